/*
 * contrast.c - see contrast.h. A bullet is compared pixel by pixel with the picture without bullets. Many bullets have
 * a core or a rim in the colour of the background, but their other pixels stand out. So the measure is the share of
 * pixels that stand out, and a small share is enough.
 */
#include "contrast.h"
#include "../machine.h"
#include "video.h"

static int colour_difference(uint32_t a, uint32_t b)
{
    static const int weight[3] = { 1, 3, 2 };
    int sum = 0;

    for (int k = 0; k < 3; k++) {
        int d = (int)(a >> 8 * k & 255) - (int)(b >> 8 * k & 255);
        sum += weight[k] * (d < 0 ? -d : d);
    }
    return sum;
}

static struct image image_of(const struct draw_target *c, uint32_t i)
{
    const struct board *b = c->b;
    const struct bullets *s = &b->bullets;
    const struct bullet_kinds *k = &b->bullet_kinds;
    uint16_t kind = s->kind[i];
    uint32_t age = bullets_age(s, i, b->core.clock);
    bool turns = k->flags[kind] & KIND_TURNS;

    const struct image image = video_image(&b->sprite_images[k->sprite[kind]], age, turns || k->spin[kind],
                                           (turns ? s->dir[i] : 0) + k->spin[kind] * age);
    return k->scale ? video_scaled_image(c, &image, k->scale[kind]) : image;
}

/* Returns the percent of bullet i's pixels inside the clip that stand out; -1: the bullet has no pixel inside the
 * clip. */
static int distinct_percent(const struct draw_target *c, const uint32_t rgb[256], uint32_t i)
{
    const struct board *b = c->b;
    const struct fb *fb = c->fb;
    const uint16_t kind = b->bullets.kind[i];
    const struct sprite pic = video_scale_sprite(&b->sprite_images[b->bullet_kinds.sprite[kind]],
                                                 b->bullet_kinds.scale ? b->bullet_kinds.scale[kind] : SCALE_ONE);
    unsigned blend = (b->bullet_kinds.flags[kind] & KIND_BLEND) / KIND_BLEND_ONE;
    struct image image = image_of(c, i);
    int x0 = c->x + fx_floor(b->bullets.x[i]) - pic.ox;
    int y0 = c->y + fx_floor(b->bullets.y[i]) - pic.oy;
    int total = 0, distinct = 0;

    for (int y = 0; y < image.h; y++)
        for (int x = 0; x < image.w; x++) {
            uint8_t p = image.pix[y * image.pitch + x];
            if (!p || x0 + x < fb->x0 || x0 + x >= fb->x1 || y0 + y < fb->y0 || y0 + y >= fb->y1)
                continue;
            uint8_t behind_entry = fb->pix[(y0 + y) * fb->pitch + x0 + x],
                    bullet_entry = (uint8_t)(p + 16 * b->bullets.bank[i]);
            if (blend)
                bullet_entry = c->palette_tables.blend[blend - 1][behind_entry << 8 | bullet_entry];
            total++;
            distinct += colour_difference(rgb[behind_entry], rgb[bullet_entry]) >= CONTRAST_THRESHOLD;
        }
    return total ? 100 * distinct / total : -1;
}

void contrast_sample(const struct board *b, struct fb *fb, void *scratch, contrast_visit *visit, void *context)
{
    const struct bullets *s = &b->bullets;
    uint32_t rgb[256];
    int n = 0, field_x, field_y;

    video_draw_behind_bullets(b, fb, rgb, scratch, &field_x, &field_y);
    const struct draw_target c = { .b = b,
                                   .fb = fb,
                                   .x = field_x,
                                   .y = field_y,
                                   .palette_tables = video_get_palette_tables(b),
                                   .copies = video_begin_copies(b, scratch) };
    EACH_LIVE (i, &s->s) {
        uint16_t kind = s->kind[i];
        if (b->bullet_kinds.flags[kind] & KIND_IS_CLOUD_ROW || b->bullet_kinds.shape[kind] == SHAPE_NONE)
            continue;
        struct contrast_bullet bullet = { .kind = board_name(b, N_BULLET, kind),
                                          .bank = s->bank[i],
                                          .x = fx_floor(s->x[i]),
                                          .y = fx_floor(s->y[i]),
                                          .share = distinct_percent(&c, rgb, i) };
        if (bullet.share < 0 || !bullet.kind)
            continue;
        visit(context, &bullet);
        if (++n == CONTRAST_MAX_BULLETS)
            break;
    }
}

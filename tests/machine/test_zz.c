#include "rig.h"
/* test_zz FOLDER "frames:buttons1:buttons2 ..." OUT frame,frame */
int main(int argc, char **argv)
{
    struct rig_game g; struct rig r; char err[512]; uint32_t rgb[256];
    (void)argc;
    if (!rom_image_load(argv[1], false, &g.image, err, sizeof err)) { puts(err); return 1; }
    struct board_start st = { .seed = 1, .difficulty = -1 };
    if (argc > 5) snprintf(st.practice.section, sizeof st.practice.section, "%s", argv[5]);
    rig_power_any(&r, &g, &st);
    unsigned f = 0;
    for (char *w = strtok(strdup(argv[2]), " "); w; w = strtok(NULL, " ")) {
        unsigned n; char a[32] = "", c[32] = "";
        sscanf(w, "%u:%31[^:]:%31s", &n, a, c);
        static const char *const k = "UDLRFBOXS";
        uint16_t pads[2] = { 0 };
        for (char *p = a; *p; p++) if (strchr(k, *p)) pads[0] |= (uint16_t)(1 << (strchr(k, *p) - k));
        for (char *p = c; *p; p++) if (strchr(k, *p)) pads[1] |= (uint16_t)(1 << (strchr(k, *p) - k));
        while (n--) {
            if (rig_fault(&r)) { printf("%u: %s\n%s\n", f, rig_fault(&r)->message, rig_fault(&r)->trace); return 1; }
            const struct board_out *o = board_tick(r.b, pads);
            if (o->log_size) printf("%u: %.*s", f, (int)o->log_size, o->log);
            f++;
            char s[300]; snprintf(s, sizeof s, ",%u,", f); char l[600]; snprintf(l, sizeof l, ",%s,", argv[4]);
            if (strstr(l, s)) {
                board_draw(r.b, &r.fb, rgb, r.scratch);
                snprintf(s, sizeof s, "%s%04u.ppm", argv[3], f);
                FILE *o2 = fopen(s, "wb"); fprintf(o2, "P6 %d %d 255\n", r.fb.w, r.fb.h);
                for (int y = 0; y < r.fb.h; y++) for (int x = 0; x < r.fb.w; x++) { uint32_t q = rgb[r.fb.pix[y * r.fb.pitch + x]]; fputc(q >> 16, o2); fputc(q >> 8 & 255, o2); fputc(q & 255, o2); }
                fclose(o2);
            }
        }
    }
    printf("end %u hash %016llx score %lld %lld\n", f, (unsigned long long)board_hash(r.b), (long long)board_points(r.b, 0), (long long)board_points(r.b, 1));
    return 0;
}

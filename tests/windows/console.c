/* console.c - a program of the console that waits: what a double click on it opens. */
#include <windows.h>

int main(void)
{
    Sleep(8000);
    return 0;
}

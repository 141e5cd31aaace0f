package javax.microedition.lcdui;

import lejos.nxt.LCD;

/** The dots of the display or of an image, and what draws on them. */
class Dots {
    final byte[] data;
    final int width;
    final int height;

    Dots(byte[] data, int width, int height) {
        this.data = data;
        this.width = width;
        this.height = height;
    }

    void fill(int x, int y, int w, int h, int operation) {
        LCD.bitBlt(data, width, height, x, y, data, width, height, x, y, w, h, operation);
    }

    void dot(int x, int y, int operation) {
        LCD.bitBlt(data, width, height, x, y, data, width, height, x, y, 1, 1, operation);
    }

    void draw(Dots source, int sourceX, int sourceY, int w, int h, int x, int y, int operation) {
        LCD.bitBlt(source.data, source.width, source.height, sourceX, sourceY, data, width, height, x, y, w, h,
            operation);
    }

    void character(Font font, char character, int x, int y, int operation) {
        int span = font.glyphWidth * font.glyphCount;
        int from = font.glyphWidth * (character - font.firstChar);
        LCD.bitBlt(font.glyphs, span, font.height, from, 0, data, width, height, x, y, font.glyphWidth, font.height,
            operation);
    }

    /** Draws a line after Bresenham; of a dotted one, the first dot and every other one after the second. */
    void line(int x0, int y0, int x1, int y1, int style, int operation) {
        if (style == Graphics.SOLID && (x0 == x1 || y0 == y1)) {
            fill(Math.min(x0, x1), Math.min(y0, y1), Math.abs(x1 - x0) + 1, Math.abs(y1 - y0) + 1, operation);
            return;
        }
        int twiceWide = 2 * Math.abs(x1 - x0);
        int twiceHigh = 2 * Math.abs(y1 - y0);
        int stepX = x1 < x0 ? -1 : 1;
        int stepY = y1 < y0 ? -1 : 1;
        boolean isFlat = twiceWide > twiceHigh;
        int along = isFlat ? twiceWide : twiceHigh;
        int across = isFlat ? twiceHigh : twiceWide;
        int rest = across - along / 2;
        int x = x0;
        int y = y0;
        dot(x, y, operation);
        for (int i = 0; i < along / 2; i++) {
            if (rest >= 0) {
                if (isFlat) y += stepY;
                else x += stepX;
                rest -= along;
            }
            if (isFlat) x += stepX;
            else y += stepY;
            rest += across;
            if (style == Graphics.SOLID || (i & 1) == 0) dot(x, y, operation);
        }
    }
}

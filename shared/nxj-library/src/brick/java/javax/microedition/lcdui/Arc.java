package javax.microedition.lcdui;

/**
 * Draws a part of an ellipse after Bresenham's circle, with five steps for each dot.
 *
 * <p>It goes through an eighth of the circle and mirrors each point seven times.
 */
class Arc {
    private static final int FINE = 5;

    private final Dots dots;
    private final int operation;
    private final boolean isDotted;
    private final boolean isFilled;

    private int centreX;
    private int centreY;

    /** Filled shapes are lines from the centre, which are moved once more after translate, as in leJOS NXJ. */
    private int lineX;
    private int lineY;

    Arc(Dots dots, int operation, boolean isDotted, boolean isFilled) {
        this.dots = dots;
        this.operation = operation;
        this.isDotted = isDotted;
        this.isFilled = isFilled;
    }

    void draw(int x, int y, int width, int height, int startAngle, int arcAngle, int moreX, int moreY) {
        centreX = x + (width >> 1);
        centreY = y + (height >> 1);
        lineX = moreX;
        lineY = moreY;
        boolean isHigh = width < height;
        int radius = (isHigh ? width : height) >> 1;
        int scaleX = isHigh ? FINE : (FINE * width + (width >> 1)) / height;
        int scaleY = isHigh ? (FINE * height + (height >> 1)) / width : FINE;
        int start = within(startAngle, 0, 360);
        int by = within(arcAngle, -360, 360);
        int from = Math.min(start, start + by);
        int to = Math.max(start, start + by);
        if (to > 360) {
            draw(radius, scaleX, scaleY, from, 360);
            draw(radius, scaleX, scaleY, 0, to - 360);
        } else if (from < 0) {
            draw(radius, scaleX, scaleY, from + 360, 360);
            draw(radius, scaleX, scaleY, 0, to);
        } else {
            draw(radius, scaleX, scaleY, from, to);
        }
    }

    private static int within(int angle, int least, int most) {
        int turn = 360;
        int result = angle;
        while (result < least) result += turn;
        while (result > most) result -= turn;
        return result;
    }

    private void draw(int radius, int scaleX, int scaleY, int from, int to) {
        int x = 0;
        int y = FINE * radius;
        int error = 1 - y;
        int steps = 0;
        while (x < y) {
            if (error >= 0) {
                y--;
                error -= 2 * y;
            }
            x++;
            error += 2 * x + 1;
            steps = (steps + 1) % (2 * FINE);
            if (isDotted && steps < 2 * FINE - 1) continue;
            mirror(scaled(x, scaleX), scaled(x, scaleY), scaled(y, scaleX), scaled(y, scaleY),
                (int) Math.round(Math.toDegrees(Math.atan2(y, x))), from, to);
        }
    }

    private static int scaled(int steps, int scale) {
        return (steps * scale + (scale >> 1)) / (FINE * FINE);
    }

    private void mirror(int xAcross, int xDown, int yAcross, int yDown, int angle, int from, int to) {
        point(90 - angle, yAcross, -xDown, from, to);
        point(angle, xAcross, -yDown, from, to);
        point(180 - angle, -xAcross, -yDown, from, to);
        point(90 + angle, -yAcross, -xDown, from, to);
        point(270 - angle, -yAcross, xDown, from, to);
        point(180 + angle, -xAcross, yDown, from, to);
        point(360 - angle, xAcross, yDown, from, to);
        point(270 + angle, yAcross, xDown, from, to);
    }

    private void point(int angle, int right, int down, int from, int to) {
        if (angle < from || angle > to) return;
        if (isFilled) {
            int x = centreX + lineX;
            int y = centreY + lineY;
            dots.line(x, y, x + right, y + down, Graphics.SOLID, operation);
        } else {
            dots.dot(centreX + right, centreY + down, operation);
        }
    }
}

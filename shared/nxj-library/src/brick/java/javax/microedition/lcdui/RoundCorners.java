package javax.microedition.lcdui;

/** Draws the four quarters of an ellipse, away from each other, dot by dot with whole numbers. */
class RoundCorners {
    private final Dots dots;
    private final int operation;

    RoundCorners(Dots dots, int operation) {
        this.dots = dots;
        this.operation = operation;
    }

    /** The ellipse around x, y is 2 a wide and 2 b high; its quarters are so many dots away to all sides. */
    void draw(int x, int y, int awayX, int awayY, int a, int b) {
        int a2 = a * a;
        int b2 = b * b;
        int right = 0;
        int down = b;
        int limitRight = -(a2 / 4 + a % 2 + b2);
        int limitDown = -(b2 / 4 + b % 2 + a2);
        int limitFlat = -(b2 / 4 + b % 2);
        int error = -a2 * down;
        int errorRight = 0;
        int errorDown = 2 * error;
        while (down >= 0 && right <= a) {
            corners(x, y, right, down, awayX, awayY);
            boolean goesRight = error + b2 * right <= limitRight || error + a2 * down <= limitFlat;
            boolean goesDown = !goesRight && error - a2 * down > limitDown;
            if (!goesDown) {
                right++;
                errorRight += 2 * b2;
                error += errorRight;
            }
            if (!goesRight) {
                down--;
                errorDown += 2 * a2;
                error += errorDown;
            }
        }
    }

    private void corners(int x, int y, int right, int down, int awayX, int awayY) {
        int atX = right + awayX;
        int atY = down + awayY;
        dots.dot(x + atX, y + atY, operation);
        if (right != 0 || down != 0) dots.dot(x - atX, y - atY, operation);
        if (right != 0 && down != 0) {
            dots.dot(x + atX, y - atY, operation);
            dots.dot(x - atX, y + atY, operation);
        }
    }
}

package javax.microedition.lcdui;

import javax.microedition.lcdui.game.Sprite;

/** Turns a picture of so many dots round, as a constant of Sprite says. */
class Turning {
    /** How wide and high it is afterwards. */
    final int width;
    final int height;

    private final int sourceWidth;
    private final int sourceHeight;

    /** How far a step to the right and a step down in the source go to the right and down in the target. */
    private int rightToRight;
    private int downToRight;
    private int rightToDown;
    private int downToDown;

    Turning(int transform, int w, int h) {
        sourceWidth = w;
        sourceHeight = h;
        rightToRight = 1;
        downToDown = 1;
        if (transform == Sprite.TRANS_MIRROR || transform == Sprite.TRANS_ROT180) rightToRight = -1;
        if (transform == Sprite.TRANS_MIRROR_ROT180 || transform == Sprite.TRANS_ROT180) downToDown = -1;
        boolean isUpright = isUpright(transform);
        width = isUpright ? h : w;
        height = isUpright ? w : h;
        if (!isUpright) return;
        rightToRight = 0;
        downToDown = 0;
        boolean isRight = transform == Sprite.TRANS_MIRROR_ROT90 || transform == Sprite.TRANS_ROT90;
        downToRight = isRight ? -1 : 1;
        rightToDown = transform == Sprite.TRANS_MIRROR_ROT270 || transform == Sprite.TRANS_ROT90 ? 1 : -1;
    }

    /** Whether width and height change places. */
    static boolean isUpright(int transform) {
        return transform >= Sprite.TRANS_MIRROR_ROT270 && transform <= Sprite.TRANS_MIRROR_ROT90;
    }

    void draw(Dots source, int sourceX, int sourceY, Dots target, int x, int y, int operation) {
        int middleX = (sourceWidth + 1) / 2;
        int middleY = (sourceHeight + 1) / 2;
        int centreX = x + (width + rightToRight + downToRight) / 2;
        int centreY = y + (height + rightToDown + downToDown) / 2;
        for (int row = 0; row < sourceHeight; row++) {
            for (int column = 0; column < sourceWidth; column++) {
                int right = column - middleX;
                int down = row - middleY;
                target.draw(source, sourceX + column, sourceY + row, 1, 1,
                    centreX + right * rightToRight + down * downToRight,
                    centreY + right * rightToDown + down * downToDown, operation);
            }
        }
    }
}

package javax.microedition.lcdui.game;

/** The ways in which Graphics and Image can turn a picture round. */
public class Sprite {
    /** As it is. */
    public static final int TRANS_NONE = 0;

    /** Upside down in a mirror. */
    public static final int TRANS_MIRROR_ROT180 = 1;

    /** As in a mirror: left and right change places. */
    public static final int TRANS_MIRROR = 2;

    /** Turned by half a turn. */
    public static final int TRANS_ROT180 = 3;

    /** As in a mirror, and turned by three quarters of a turn to the right. */
    public static final int TRANS_MIRROR_ROT270 = 4;

    /** Turned by a quarter of a turn to the right. */
    public static final int TRANS_ROT90 = 5;

    /** Turned by three quarters of a turn to the right. */
    public static final int TRANS_ROT270 = 6;

    /** As in a mirror, and turned by a quarter of a turn to the right. */
    public static final int TRANS_MIRROR_ROT90 = 7;

    /** Makes one; all that a program needs is constant. */
    public Sprite() {
    }
}

package javax.microedition.lcdui;

import lejos.nxt.Sound;

/**
 * Something that the display tells in place of another screen until ENTER is pressed or its time is over.
 *
 * <p>It sounds a rising tune. Of the kind ALERT_TYPE_CONFIRMATION it is a question: LEFT is no, RIGHT is yes.
 */
public class Alert extends Screen {
    /** It stays until ENTER is pressed. */
    public static final int FOREVER = -2;

    /** Something to know. */
    public static final int ALERT_TYPE_INFO = 0;

    /** A warning. */
    public static final int ALERT_TYPE_WARNING = 1;

    /** A mistake. */
    public static final int ALERT_TYPE_ERROR = 2;

    /** An alarm. */
    public static final int ALERT_TYPE_ALARM = 3;

    /** A question. */
    public static final int ALERT_TYPE_CONFIRMATION = 4;

    /** The word for yes. */
    public static final String STR_CONFIRM = "Yes";

    /** The word for no. */
    public static final String STR_DENY = "No";

    /** The picture of something to know: an i. */
    public static final Image IMG_INFO = new Image(16, 16, new byte[] {
        -64, 48, 12, 4, 2, 2, -127, -79, -79, 1, 2, 2, 4, 12, 48, -64,
        3, 12, 48, 32, 64, 64, -120, -113, -113, -120, 64, 64, 32, 48, 12, 3,
    });

    /** The picture of a warning: an exclamation mark. */
    public static final Image IMG_WARNING = new Image(16, 16, new byte[] {
        -64, 48, 12, 4, 2, 2, 1, -15, -15, 1, 2, 2, 4, 12, 48, -64,
        3, 12, 48, 32, 64, 64, -128, -115, -115, -128, 64, 64, 32, 48, 12, 3,
    });

    /** The picture of a mistake: a cross. */
    public static final Image IMG_ERROR = new Image(16, 16, new byte[] {
        -64, 48, 12, 4, 2, 50, 113, -63, -63, 113, 50, 2, 4, 12, 48, -64,
        3, 12, 48, 32, 64, 76, -114, -125, -125, -114, 76, 64, 32, 48, 12, 3,
    });

    /** The picture of an alarm: a bell. */
    public static final Image IMG_ALARM = new Image(16, 16, new byte[] {
        -64, 48, 12, 4, 2, 2, -31, -15, -15, -31, 2, 2, 4, 12, 48, -64,
        3, 12, 48, 32, 64, 66, -125, -117, -117, -125, 66, 64, 32, 48, 12, 3,
    });

    /** The picture of a question: a question mark. */
    public static final Image IMG_CONFIRM = new Image(16, 16, new byte[] {
        -64, 48, 12, 4, 2, 34, 49, 17, -111, -15, 98, 2, 4, 12, 48, -64,
        3, 12, 48, 32, 64, 64, -128, -115, -115, -128, 64, 64, 32, 48, 12, 3,
    });

    private static final Image[] PICTURES = {IMG_INFO, IMG_WARNING, IMG_ERROR, IMG_ALARM, IMG_CONFIRM};
    private static final int ROW = Display.CHAR_HEIGHT;
    private static final int MIDDLE = Display.SCREEN_WIDTH / 2;

    private final Command end = new Command(0, Command.SCREEN, 0);
    private String text;
    private final Image picture;
    private Gauge indicator;
    private int type;
    private int timeout = FOREVER;
    private boolean isConfirmed;

    /** Makes one with a title; give it a text with setString, too. */
    public Alert(String title) {
        this(title, null, null, ALERT_TYPE_INFO);
    }

    /** Makes one with a title, a text, a picture, null for that of its kind, and a kind such as ALERT_TYPE_INFO. */
    public Alert(String title, String alertText, Image alertImage, int alertType) {
        this.title = title;
        text = alertText;
        picture = alertImage;
        type = alertType;
        commands.add(end);
    }

    /** Sets the kind, such as ALERT_TYPE_INFO. */
    public void setType(int alertType) {
        type = alertType;
    }

    /** Sets the text. */
    public void setString(String alertText) {
        text = alertText;
    }

    /** Sets after how many milliseconds it goes away, FOREVER for never. */
    public void setTimeout(int time) {
        timeout = time;
    }

    /** Gives after how many milliseconds it goes away, or FOREVER. */
    public int getTimeout() {
        return timeout;
    }

    /** Tells whether the answer is yes. */
    public boolean getConfirmation() {
        return isConfirmed;
    }

    /** Sets a value to be shown, without a label, that the buttons cannot change. */
    public void setIndicator(Gauge indicator) {
        if (indicator.isInteractive() || indicator.label != null) throw new IllegalArgumentException();
        this.indicator = indicator;
    }

    /** Gives the value that is shown, or null. */
    public Gauge getIndicator() {
        return indicator;
    }

    /** Is told that a button was pressed, such as KEY_LEFT. */
    protected void keyPressed(int keyCode) {
        if (keyCode == KEY_ENTER && cmdListener != null) {
            cmdListener.commandAction(end, this);
        } else if (type == ALERT_TYPE_CONFIRMATION) {
            if (keyCode == KEY_LEFT) isConfirmed = false;
            if (keyCode == KEY_RIGHT) isConfirmed = true;
            repaint();
        }
    }

    /** Is told that it is shown from now on, and sounds. */
    protected void showNotify() {
        new Thread() {
            public void run() {
                Sound.beepSequenceUp();
            }
        }.start();
        repaint();
    }

    /** Draws the title white on black, the picture, the text, and the answer or the value. */
    public void paint(Graphics g) {
        g.fillRect(0, 0, Display.SCREEN_WIDTH, 2 * ROW);
        g.drawString(title, MIDDLE, ROW / 2, Graphics.HCENTER, true);
        g.drawImage(picture == null ? PICTURES[type] : picture, 0, 20, 0);
        g.drawString(text, 3 * Display.CHAR_WIDTH, 3 * ROW, 0);
        if (type == ALERT_TYPE_CONFIRMATION) {
            g.drawString(isConfirmed ? STR_CONFIRM : STR_DENY, MIDDLE, 4 * ROW, Graphics.HCENTER, true);
        } else if (indicator != null) {
            indicator.paint(g, 0, 4 * ROW, Display.SCREEN_WIDTH, 4 * ROW, false);
        }
    }
}

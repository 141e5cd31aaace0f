package javax.microedition.lcdui;

import lejos.nxt.Button;
import lejos.nxt.ButtonListener;
import lejos.nxt.LCD;
import lejos.util.Delay;
import lejos.util.Timer;
import lejos.util.TimerListener;

/**
 * The display as screens that follow each other: setCurrent says which one, and show gives it the buttons.
 *
 * <p>From the first getDisplay on, what LCD draws becomes visible only by LCD.refresh.
 */
public class Display {
    /** The width in dots. */
    public static final int SCREEN_WIDTH = 100;

    /** The height in dots. */
    public static final int SCREEN_HEIGHT = 64;

    /** How many dots a character is wide. */
    public static final int CHAR_WIDTH = 6;

    /** How many dots a row is high. */
    public static final int CHAR_HEIGHT = 8;

    /** How many characters a row has. */
    public static final int SCREEN_CHAR_WIDTH = SCREEN_WIDTH / CHAR_WIDTH;

    /** How many rows there are. */
    public static final int SCREEN_CHAR_DEPTH = CHAR_HEIGHT;

    private static final int TICKER_PERIOD = 100;
    private static final int UPDATE_PERIOD = 50;
    private static final int DEBOUNCING = 20;

    private static Display display;

    /** What draws the screens. */
    protected Graphics graphics;

    private Screen current;
    private Screen behindAlert;
    private int alertEnd;
    private int tickerX = SCREEN_WIDTH;
    private boolean isToQuit;

    private Display() {
        graphics = new Graphics();
        LCD.setAutoRefresh(false);
    }

    /** Gives the display. */
    public static Display getDisplay() {
        if (display == null) display = new Display();
        return display;
    }

    /** Sets which screen is shown; behind an Alert, the screen before comes again. */
    public void setCurrent(Screen nextDisplayable) {
        if (nextDisplayable == null) return;
        if (nextDisplayable instanceof Alert) {
            if (behindAlert == null) behindAlert = current;
            alertEnd = end((Alert) nextDisplayable);
        }
        change(nextDisplayable);
    }

    /** Shows an Alert and then a screen. */
    public void setCurrent(Alert alert, Screen nextDisplayable) {
        if (alert == null || nextDisplayable == null) return;
        behindAlert = nextDisplayable;
        alertEnd = end(alert);
        change(alert);
    }

    private static int end(Alert alert) {
        int timeout = alert.getTimeout();
        return timeout == Alert.FOREVER ? Alert.FOREVER : (int) System.currentTimeMillis() + timeout;
    }

    private void change(Screen next) {
        if (current != null) current.hideNotify();
        tickerX = SCREEN_WIDTH;
        current = next;
        current.showNotify();
        current.repaint();
    }

    /** Gives the screen that is shown. */
    public Displayable getCurrent() {
        return current;
    }

    /** Ends the program, as soon as show or its threads look. */
    public void quit() {
        isToQuit = true;
    }

    /** Gives the screens the buttons: true until quit ends the program, false in threads of its own. */
    public void show(boolean polling) {
        if (!polling) {
            showInThreads();
            return;
        }
        int nextTick = (int) System.currentTimeMillis();
        while (!isToQuit) {
            while (!isToQuit && Button.readButtons() > 0) Thread.yield();
            while (!isToQuit && Button.readButtons() == 0) {
                if (isOver(nextTick)) {
                    tick();
                    nextTick = (int) System.currentTimeMillis() + TICKER_PERIOD;
                }
                endAlert();
                update();
                Thread.yield();
            }
            if (current == null) continue;
            Delay.msDelay(DEBOUNCING);
            int key = key(Button.readButtons());
            if (key != 0) press(key);
        }
        System.exit(0);
    }

    private static int key(int buttons) {
        if (buttons == Button.ID_ENTER) return Displayable.KEY_ENTER;
        if (buttons == Button.ID_LEFT) return Displayable.KEY_LEFT;
        if (buttons == Button.ID_RIGHT) return Displayable.KEY_RIGHT;
        return buttons == Button.ID_ESCAPE ? Displayable.KEY_BACK : 0;
    }

    private void showInThreads() {
        ButtonListener listener = new ButtonListener() {
            public void buttonPressed(Button b) {
                if (current != null) press(key(b.getId()));
            }

            public void buttonReleased(Button b) {
            }
        };
        Button.ENTER.addButtonListener(listener);
        Button.ESCAPE.addButtonListener(listener);
        Button.LEFT.addButtonListener(listener);
        Button.RIGHT.addButtonListener(listener);
        new Timer(TICKER_PERIOD, new TimerListener() {
            public void timedOut() {
                tick();
            }
        }).start();
        new Timer(UPDATE_PERIOD, new TimerListener() {
            public void timedOut() {
                endAlert();
                if (isToQuit) System.exit(0);
                update();
            }
        }).start();
    }

    private void press(int key) {
        Screen pressed = current;
        pressed.keyPressed(key);
        if (key == Displayable.KEY_ENTER && pressed instanceof Alert && pressed == current) leaveAlert();
        update();
    }

    private void endAlert() {
        if (current instanceof Alert && alertEnd != Alert.FOREVER && isOver(alertEnd)) leaveAlert();
    }

    private void leaveAlert() {
        current.hideNotify();
        current = behindAlert;
        behindAlert = null;
    }

    private static boolean isOver(int time) {
        return (int) System.currentTimeMillis() - time > 0;
    }

    private synchronized void update() {
        if (!current.getPaintRequest()) return;
        LCD.clear();
        paintTicker();
        current.paint(graphics);
        current.clearPaintRequest();
        LCD.refresh();
    }

    private void tick() {
        int width = paintTicker();
        if (width <= 0) return;
        tickerX--;
        if (tickerX < -width) tickerX = SCREEN_WIDTH;
    }

    /** Gives how many dots the text is wide; 0 if there is none. */
    private int paintTicker() {
        Ticker ticker = current.getTicker();
        if (ticker == null) return 0;
        int color = graphics.getColor();
        graphics.setColor(Graphics.WHITE);
        graphics.fillRect(0, 0, SCREEN_WIDTH, CHAR_HEIGHT);
        graphics.setColor(color);
        graphics.drawString(ticker.getString(), tickerX, 0, 0);
        LCD.refresh();
        return ticker.getString().length() * CHAR_WIDTH;
    }
}

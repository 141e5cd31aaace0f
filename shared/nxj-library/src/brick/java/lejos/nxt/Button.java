package lejos.nxt;

import lejos.util.Delay;

/** One of the brick's buttons: Button.ENTER, Button.LEFT, Button.RIGHT and Button.ESCAPE. */
public class Button implements ListenerCaller {
    /** The number of the orange button. */
    public static final int ID_ENTER = 1;

    /** The number of the left button. */
    public static final int ID_LEFT = 2;

    /** The number of the right button. */
    public static final int ID_RIGHT = 4;

    /** The number of the button below. */
    public static final int ID_ESCAPE = 8;

    /** The setting for the volume of a click. */
    public static final String VOL_SETTING = "lejos.keyclick_volume";

    /** The orange button. */
    public static final Button ENTER = new Button(ID_ENTER);

    /** The left button. */
    public static final Button LEFT = new Button(ID_LEFT);

    /** The right button. */
    public static final Button RIGHT = new Button(ID_RIGHT);

    /** The button below. */
    public static final Button ESCAPE = new Button(ID_ESCAPE);

    /**
     * All buttons: ENTER, LEFT, RIGHT and ESCAPE.
     *
     * @deprecated leJOS NXJ means to remove this array.
     */
    @Deprecated
    public static final Button[] BUTTONS = {ENTER, LEFT, RIGHT, ESCAPE};

    private static final int ALL = 15;
    private static final int RELEASED_SHIFT = 8;
    private static final int PERIOD = 10;
    private static final int MOST_LISTENERS = 4;
    private static final Object state = new Object();

    private static int volume = 20;
    private static int length = 50;
    private static final int[] tones = {906, 979, 1061, 1150};

    /** What was down when the program last looked, and when it last waited for a change. */
    private static int seen;
    private static int known;

    private final int id;
    private ButtonListener[] listeners;
    private int count;
    private boolean wasDown;

    private Button(int id) {
        this.id = id;
    }

    /** Gives the button's number: 1 for ENTER, 2 for LEFT, 4 for RIGHT, 8 for ESCAPE. */
    public final int getId() {
        return id;
    }

    /** Says whether the button is down at this moment. */
    public final boolean isDown() {
        return (readButtons() & id) != 0;
    }

    /** Says whether the button is up at this moment. */
    public final boolean isUp() {
        return (readButtons() & id) == 0;
    }

    /**
     * Says whether the button is down at this moment.
     *
     * @deprecated use isDown.
     */
    @Deprecated
    public final boolean isPressed() {
        return isDown();
    }

    /** Waits until somebody presses the button; if it is down already, it must be let go first. */
    public final void waitForPress() {
        NXTEvent event = allocate();
        while (isDown()) event.waitEvent(NXTEvent.WAIT_FOREVER);
        while (!isDown()) event.waitEvent(NXTEvent.WAIT_FOREVER);
        event.free();
    }

    /** Waits until somebody has pressed the button and let go of it. */
    public final void waitForPressAndRelease() {
        waitForPress();
        NXTEvent event = allocate();
        while (isDown()) event.waitEvent(NXTEvent.WAIT_FOREVER);
        event.free();
    }

    /** Waits until any button is pressed, and gives its number. */
    public static int waitForAnyPress() {
        return waitForAnyPress(0);
    }

    /** Waits until any button is pressed, at most so many milliseconds, and gives its number, or 0; 0 are for ever. */
    public static int waitForAnyPress(int timeout) {
        long end = System.currentTimeMillis() + timeout;
        int rest = timeout;
        while (timeout == 0 || rest > 0) {
            int pressed = waitForAnyEvent(rest) & ALL;
            if (pressed != 0) return pressed;
            if (timeout != 0) rest = (int) (end - System.currentTimeMillis());
        }
        return 0;
    }

    /**
     * Waits until any button is pressed or released, and gives which: pressed ones, and 256 times released ones.
     *
     * @hidden
     */
    public static int waitForAnyEvent() {
        return waitForAnyEvent(0);
    }

    /** Waits until any button is pressed or released, at most so many milliseconds, and gives which, or 0. */
    public static int waitForAnyEvent(int timeout) {
        long end = System.currentTimeMillis() + timeout;
        NXTEvent event = allocate();
        try {
            while (true) {
                int change = change();
                if (change != 0) return change;
                long rest = timeout == 0 ? NXTEvent.WAIT_FOREVER : end - System.currentTimeMillis();
                if (timeout != 0 && rest <= 0) return 0;
                event.waitEvent(rest);
            }
        } finally {
            event.free();
        }
    }

    /** Forgets what was pressed and released until now. */
    public static void discardEvents() {
        synchronized (state) {
            known = readButtons();
        }
    }

    /** Gives the numbers of all buttons that are down at this moment, added up. */
    public static int readButtons() {
        synchronized (state) {
            int down = getButtons();
            int pressed = down & ~seen;
            seen = down;
            if (pressed != 0) click(pressed);
            return down;
        }
    }

    /** Tells a listener from now on when the button is pressed or released; there can be four. */
    public synchronized void addButtonListener(ButtonListener listener) {
        boolean isFirst = listeners == null;
        if (isFirst) listeners = new ButtonListener[MOST_LISTENERS];
        listeners[count] = listener;
        count++;
        if (isFirst) {
            wasDown = isDown();
            ListenerThread.watch(this, NXTEvent.BUTTONS, id | id << RELEASED_SHIFT, PERIOD);
        }
    }

    /** Tells all listeners; the brick calls it, programs need not. */
    public synchronized int callListeners() {
        boolean isDown = isDown();
        if (isDown != wasDown) {
            wasDown = isDown;
            for (int index = 0; index < count; index++) {
                if (isDown) {
                    listeners[index].buttonPressed(this);
                } else {
                    listeners[index].buttonReleased(this);
                }
            }
        }
        return NXTEvent.BUTTONS;
    }

    /** Sets how loud a button clicks, 0 to 100; 0 is not at all. */
    public static void setKeyClickVolume(int volume) {
        Button.volume = volume;
    }

    /** Gives how loud a button clicks; 20 if nobody sets it. */
    public static int getKeyClickVolume() {
        return volume;
    }

    /** Sets how many milliseconds a button clicks. */
    public static void setKeyClickLength(int length) {
        Button.length = length;
    }

    /** Gives how many milliseconds a button clicks; 50 if nobody sets it. */
    public static int getKeyClickLength() {
        return length;
    }

    /** Sets the tone in hertz that the button with a number clicks. */
    public static void setKeyClickTone(int id, int frequency) {
        tones[place(id)] = frequency;
    }

    /** Gives the tone in hertz that the button with a number clicks. */
    public static int getKeyClickTone(int id) {
        return tones[place(id)];
    }

    private static NXTEvent allocate() {
        NXTEvent event = NXTEvent.allocate(NXTEvent.BUTTONS, ALL | ALL << RELEASED_SHIFT, PERIOD);
        while (event == null) {
            // Sixteen others are being waited for.
            Delay.msDelay(PERIOD);
            event = NXTEvent.allocate(NXTEvent.BUTTONS, ALL | ALL << RELEASED_SHIFT, PERIOD);
        }
        return event;
    }

    private static int change() {
        synchronized (state) {
            int down = readButtons();
            int pressed = down & ~known;
            int released = known & ~down;
            known = down;
            return pressed | released << RELEASED_SHIFT;
        }
    }

    private static void click(int pressed) {
        if (volume == 0) return;
        int frequency = 0;
        for (int place = 0; place < tones.length; place++) {
            if ((pressed & 1 << place) != 0) frequency = tones[place];
        }
        if (frequency != 0) Sound.playTone(frequency, length, -volume);
    }

    private static int place(int id) {
        int place = 0;
        while (place < 3 && id != 1 << place) place++;
        if (id != 1 << place) throw new IllegalArgumentException();
        return place;
    }

    private static native int getButtons();
}

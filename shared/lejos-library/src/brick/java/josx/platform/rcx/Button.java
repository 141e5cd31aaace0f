package josx.platform.rcx;

/** One of the brick's buttons: Button.RUN, Button.VIEW and Button.PRGM. */
public class Button implements ListenerCaller {
    /** The button Run. */
    public static final Button RUN = new Button(1);

    /** The button View. */
    public static final Button VIEW = new Button(2);

    /** The button Prgm. */
    public static final Button PRGM = new Button(4);

    /** The three buttons: Run, View, Prgm. */
    public static final Button[] BUTTONS = {RUN, VIEW, PRGM};

    private static final int MOST_LISTENERS = 4;

    // The ROM writes into it, so that its address has to stay the same.
    private static final short[] pressed = new short[1];
    private static final int pressedAddress = Memory.getDataAddress(pressed);

    private final int id;
    private ButtonListener[] listeners;
    private int count;
    private Poll poll;

    private Button(int id) {
        this.id = id;
    }

    /** Gives the button's number: 1 for Run, 2 for View, 4 for Prgm. */
    public final int getId() {
        return id;
    }

    /** Says whether the button is pressed at this moment. */
    public final boolean isPressed() {
        return (readButtons() & id) != 0;
    }

    /** Waits until somebody has pressed the button and let go of it. */
    public final void waitForPressAndRelease() throws InterruptedException {
        if (poll == null) poll = new Poll();
        do {
            poll.poll(id << Poll.BUTTON_MASK_SHIFT, 0);
        } while (isPressed());
    }

    /** Tells a listener from now on when the button is pressed or released; there can be four. */
    public synchronized void addButtonListener(ButtonListener listener) {
        if (listeners == null) listeners = new ButtonListener[MOST_LISTENERS];
        listeners[count] = listener;
        count++;
        ListenerThread.watch(id << Poll.BUTTON_MASK_SHIFT);
    }

    /** Gives the numbers of all buttons that are pressed at this moment, added up. */
    public static int readButtons() {
        synchronized (Memory.MONITOR) {
            ROM.call((short) 0x1fb6, (short) 0x3000, (short) pressedAddress);
            return pressed[0];
        }
    }

    /** Tells all listeners; the brick calls it, programs need not. */
    public synchronized void callListeners() {
        boolean isDown = isPressed();
        for (int index = 0; index < count; index++) {
            if (isDown) {
                listeners[index].buttonPressed(this);
            } else {
                listeners[index].buttonReleased(this);
            }
        }
    }
}

package lejos.nxt;

/** Is told when a button is pressed or released. */
public interface ButtonListener {
    /** The button was pressed. */
    void buttonPressed(Button button);

    /** The button was released. */
    void buttonReleased(Button button);
}

package josx.platform.rcx;

/** Is told when a button is pressed or released. */
public interface ButtonListener {
    /** Is called when the button is pressed. */
    void buttonPressed(Button button);

    /** Is called when the button is released. */
    void buttonReleased(Button button);
}

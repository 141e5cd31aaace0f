package josx.rcxcomm.remotecontrol;

import josx.platform.rcx.Motor;

/** Is told when a button of LEGO's remote control is pressed. */
public interface RemoteControlListener {
    /** Is called when the button of message 1 is pressed. */
    void message1Pressed();

    /** Is called when the button of message 2 is pressed. */
    void message2Pressed();

    /** Is called when the button of message 3 is pressed. */
    void message3Pressed();

    /** Is called when the button of program 1 is pressed. */
    void program1Pressed();

    /** Is called when the button of program 2 is pressed. */
    void program2Pressed();

    /** Is called when the button of program 3 is pressed. */
    void program3Pressed();

    /** Is called when the button of program 4 is pressed. */
    void program4Pressed();

    /** Is called when the button of program 5 is pressed. */
    void program5Pressed();

    /** Is called when the arrow down of a motor is pressed. */
    void motorDownPressed(Motor motor);

    /** Is called when the arrow up of a motor is pressed. */
    void motorUpPressed(Motor motor);

    /** Is called when the button with the note is pressed. */
    void soundPressed();

    /** Is called when the button stop is pressed. */
    void stopPressed();
}

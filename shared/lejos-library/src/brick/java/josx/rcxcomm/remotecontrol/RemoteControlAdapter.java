package josx.rcxcomm.remotecontrol;

import josx.platform.rcx.Motor;

/** Does nothing with any button of LEGO's remote control: extend it and write only those you need. */
public class RemoteControlAdapter implements RemoteControlListener {
    /** Makes one. */
    public RemoteControlAdapter() {
    }

    /** Is called when the button of message 1 is pressed. */
    public void message1Pressed() {
    }

    /** Is called when the button of message 2 is pressed. */
    public void message2Pressed() {
    }

    /** Is called when the button of message 3 is pressed. */
    public void message3Pressed() {
    }

    /** Is called when the button of program 1 is pressed. */
    public void program1Pressed() {
    }

    /** Is called when the button of program 2 is pressed. */
    public void program2Pressed() {
    }

    /** Is called when the button of program 3 is pressed. */
    public void program3Pressed() {
    }

    /** Is called when the button of program 4 is pressed. */
    public void program4Pressed() {
    }

    /** Is called when the button of program 5 is pressed. */
    public void program5Pressed() {
    }

    /** Is called when the arrow down of a motor is pressed. */
    public void motorDownPressed(Motor motor) {
    }

    /** Is called when the arrow up of a motor is pressed. */
    public void motorUpPressed(Motor motor) {
    }

    /** Is called when the button with the note is pressed. */
    public void soundPressed() {
    }

    /** Is called when the button stop is pressed. */
    public void stopPressed() {
    }
}

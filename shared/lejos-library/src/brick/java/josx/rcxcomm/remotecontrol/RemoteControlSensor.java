package josx.rcxcomm.remotecontrol;

import java.util.Vector;
import josx.platform.rcx.Motor;
import josx.platform.rcx.Opcode;
import josx.platform.rcx.Serial;
import josx.platform.rcx.SerialListener;

/** Receives LEGO's remote control and tells its listeners which button was pressed. */
public class RemoteControlSensor implements SerialListener {
    private static final int SHORTEST_PACKET = 3;
    private static final int MOTORS_UP = 3;
    private static final int MOTORS_DOWN = 6;
    private static final int PROGRAMS = 9;
    private static final int STOP = 14;

    private static final Motor[] MOTORS = {Motor.A, Motor.B, Motor.C};

    private final Vector listeners = new Vector(2, 2);

    /** Makes one. */
    public RemoteControlSensor() {
        Serial.addSerialListener(this);
    }

    /** Tells a listener from now on. */
    public void addRemoteControlListener(RemoteControlListener listener) {
        listeners.addElement(listener);
    }

    /** Tells a listener no longer. */
    public void removeRemoteControlListener(RemoteControlListener listener) {
        listeners.removeElement(listener);
    }

    /** Is called when a packet has come. */
    public void packetAvailable(byte[] packet, int length) {
        boolean isRemote = (packet[0] & Opcode.OPCODE_MASK) == (Opcode.OPCODE_REMOTE_COMMAND & Opcode.OPCODE_MASK);
        if (length < SHORTEST_PACKET || !isRemote) return;
        int bits = (packet[1] & 0xFF) << 8 | packet[2] & 0xFF;
        int button = 0;
        while (bits != 1) {
            if (bits == 0 || (bits & 1) != 0) return;
            bits >>= 1;
            button++;
        }
        for (int index = 0; index < listeners.size(); index++) tell((RemoteControlListener) listeners.elementAt(index), button);
    }

    /** Each button has a bit of its own, in this order. */
    private static void tell(RemoteControlListener listener, int button) {
        if (button < MOTORS_UP) {
            tellMessage(listener, button);
        } else if (button < MOTORS_DOWN) {
            listener.motorUpPressed(MOTORS[button - MOTORS_UP]);
        } else if (button < PROGRAMS) {
            listener.motorDownPressed(MOTORS[button - MOTORS_DOWN]);
        } else if (button < STOP) {
            tellProgram(listener, button - PROGRAMS);
        } else if (button == STOP) {
            listener.stopPressed();
        } else {
            listener.soundPressed();
        }
    }

    private static void tellMessage(RemoteControlListener listener, int message) {
        if (message == 0) listener.message1Pressed();
        if (message == 1) listener.message2Pressed();
        if (message == 2) listener.message3Pressed();
    }

    private static void tellProgram(RemoteControlListener listener, int program) {
        if (program == 0) listener.program1Pressed();
        if (program == 1) listener.program2Pressed();
        if (program == 2) listener.program3Pressed();
        if (program == 3) listener.program4Pressed();
        if (program == 4) listener.program5Pressed();
    }
}

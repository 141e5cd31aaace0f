package lejos.nxt.addon;

/** What sends bytes to an RCX by infrared light. */
public interface IRTransmitter {
    /** Sends bytes as they are. */
    void sendBytes(byte[] data, int len);

    /** Sends a message: an opcode and what belongs to it. */
    void sendPacket(byte[] packet);

    /** Presses keys of a remote control: a bit each. */
    void sendRemoteCommand(int msg);

    /** Starts a program, 1 to 5. */
    void runProgram(int programNumber);

    /** Turns a motor forward, 0 for A to 2 for C. */
    void forwardStep(int motor);

    /** Turns a motor backward, 0 for A to 2 for C. */
    void backwardStep(int motor);

    /** Lets the RCX beep. */
    void beep();

    /** Ends the program of the RCX. */
    void stopAllPrograms();
}

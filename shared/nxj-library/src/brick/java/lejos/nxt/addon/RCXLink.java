package lejos.nxt.addon;

import lejos.nxt.I2CPort;
import lejos.nxt.I2CSensor;
import lejos.nxt.rcxcomm.Opcode;
import lejos.util.Delay;

/** The link of mindsensors to an RCX: it sends messages by infrared light, and hears bytes. */
public class RCXLink extends I2CSensor implements Opcode, IRTransmitter {
    /** The macro that lets the RCX send near. */
    public static final byte SHORT_RANGE_IR = 0x01;

    /** The macro that lets the RCX send far. */
    public static final byte LONG_RANGE_IR = 0x04;

    /** The macro that switches the RCX off. */
    public static final byte POWER_OFF_RCX = 0x07;

    /** The macro that starts program 1. */
    public static final byte RUN_PROGRAM_1 = 0x09;

    /** The macro that starts program 2. */
    public static final byte RUN_PROGRAM_2 = 0x0D;

    /** The macro that starts program 3. */
    public static final byte RUN_PROGRAM_3 = 0x11;

    /** The macro that starts program 4. */
    public static final byte RUN_PROGRAM_4 = 0x15;

    /** The macro that starts program 5. */
    public static final byte RUN_PROGRAM_5 = 0x19;

    /** The macro that ends the program. */
    public static final byte STOP_ALL_PROGRAMS = 0x1D;

    /** The macro that turns motor A forward. */
    public static final byte MOTOR_A_FORWARD = 0x21;

    /** The macro that turns motor A backward. */
    public static final byte MOTOR_A_REVERSED = 0x25;

    /** The macro that turns motor B forward. */
    public static final byte MOTOR_B_FORWARD = 0x29;

    /** The macro that turns motor B backward. */
    public static final byte MOTOR_B_REVERSED = 0x2D;

    /** The macro that turns motor C forward. */
    public static final byte MOTOR_C_FORWARD = 0x31;

    /** The macro that turns motor C backward. */
    public static final byte MOTOR_C_REVERSED = 0x35;

    /** The macro that lets the RCX beep; an RCX hears it twice only if another one comes in between. */
    public static final byte BEEP = 0x39;

    /** Where a program's own macro is. */
    public static final int EEPROM_BUFFER = 0x78;

    /** How many milliseconds the link needs between two messages. */
    public static final int DELAY = 10;

    private static final int REG_LENGTH = 0x40;
    private static final int REG_COMMAND = 0x41;
    private static final int REG_DATA = 0x42;
    private static final byte SLOW = 0x44;
    private static final byte FLUSH = 0x46;
    private static final byte FAST = 0x48;
    private static final byte LONG_RANGE = 0x4C;
    private static final byte APDA_ON = 0x4E;
    private static final byte APDA_OFF = 0x4F;
    private static final byte RUN = 0x52;
    private static final byte SHORT_RANGE = 0x53;
    private static final byte RAW = 0x55;
    private static final int MACRO_BYTES = 4;
    private static final int BRAKE = 0x40;
    private static final int ON_OR_FORWARD = 0x80;
    private static final byte CONSTANT = 2;

    /** The motor A of the RCX. */
    public RCXMotor A = new RCXMotor(new RCXRemoteMotorPort(this, 0));

    /** The motor B of the RCX. */
    public RCXMotor B = new RCXMotor(new RCXRemoteMotorPort(this, 1));

    /** The motor C of the RCX. */
    public RCXMotor C = new RCXMotor(new RCXRemoteMotorPort(this, 2));

    private final byte[] one = new byte[1];

    /** Makes the link of a port. */
    public RCXLink(I2CPort port) {
        super(port);
    }

    /** Sends the macro at a place of the link's memory. */
    public void runMacro(int addr) {
        sendData(REG_COMMAND, new byte[] {RUN, (byte) addr}, 2);
    }

    /** Lets the RCX beep; an RCX hears it twice only if something else comes in between. */
    public void beep() {
        runMacro(BEEP);
    }

    /** Starts a program, 1 to 5. */
    public void runProgram(int programNumber) {
        runMacro(RUN_PROGRAM_1 + (programNumber - 1) * MACRO_BYTES);
    }

    /** Turns a motor forward, 0 for A to 2 for C. */
    public void forwardStep(int id) {
        runMacro(MOTOR_A_FORWARD + id * 2 * MACRO_BYTES);
    }

    /** Turns a motor backward, 0 for A to 2 for C. */
    public void backwardStep(int id) {
        runMacro(MOTOR_A_REVERSED + id * 2 * MACRO_BYTES);
    }

    /** Lets the RCX send near. */
    public void setRCXRangeShort() {
        runMacro(SHORT_RANGE_IR);
    }

    /** Lets the RCX send far. */
    public void setRCXRangeLong() {
        runMacro(LONG_RANGE_IR);
    }

    /** Switches the RCX off. */
    public void powerOff() {
        runMacro(POWER_OFF_RCX);
    }

    /** Ends the program of the RCX. */
    public void stopAllPrograms() {
        runMacro(STOP_ALL_PROGRAMS);
    }

    /** Forgets the bytes that the link has heard. */
    public void flush() {
        sendData(REG_COMMAND, FLUSH);
    }

    /** Lets the link send at the usual speed, that of an RCX. */
    public void setDefaultSpeed() {
        sendData(REG_COMMAND, SLOW);
    }

    /** Lets the link send twice as fast, which an RCX with its usual speed does not understand. */
    public void setHighSpeed() {
        sendData(REG_COMMAND, FAST);
    }

    /** Lets the link send far. */
    public void setRangeLong() {
        sendData(REG_COMMAND, LONG_RANGE);
    }

    /** Lets the link send near. */
    public void setRangeShort() {
        sendData(REG_COMMAND, SHORT_RANGE);
    }

    /** Lets the link share its port with others of mindsensors. */
    public void setAPDAOn() {
        sendData(REG_COMMAND, APDA_ON);
    }

    /** Lets the link be alone at its port. */
    public void setAPDAOff() {
        sendData(REG_COMMAND, APDA_OFF);
    }

    /** Writes a message into the link's memory. */
    public void defineMacro(int addr, byte[] macro) {
        sendData(addr, (byte) macro.length);
        pause();
        sendData(addr + 1, macro, macro.length);
    }

    /** Gives 1 while the link sends, and otherwise 0. */
    public int getStatus() {
        return read(REG_COMMAND);
    }

    /** Gives how many bytes the link has heard. */
    public int bytesAvailable() {
        return read(REG_LENGTH);
    }

    /** Asks the RCX whether it is there; it answers with bytes. */
    public void ping() {
        send(OPCODE_ALIVE);
    }

    /** Sends a message of one byte, for the program of the RCX. */
    public void sendF7(int msg) {
        send(OPCODE_SET_MESSAGE, (byte) msg);
    }

    /** Sends a message: an opcode and what belongs to it. */
    public void sendPacket(byte[] packet) {
        defineAndRun(packet, packet.length);
    }

    /** Presses keys of a remote control: a bit each. */
    public void sendRemoteCommand(int msg) {
        send(OPCODE_REMOTE_COMMAND, (byte) (msg >> 8), (byte) msg);
    }

    /** Sets the power of a motor, 0 for A to 2 for C, 0 to 7. */
    public void setMotorPower(int id, int power) {
        byte[] macro = {OPCODE_SET_MOTOR_POWER, (byte) (1 << id), CONSTANT, (byte) power};
        defineMacro(EEPROM_BUFFER, macro);
        pause();
        sendData(EEPROM_BUFFER + macro.length, (byte) power);
        pause();
        runMacro(EEPROM_BUFFER);
    }

    /** Brakes a motor, 0 for A to 2 for C. */
    public void stopMotor(int id) {
        send(OPCODE_SET_MOTOR_ON_OFF, (byte) (1 << id | BRAKE));
    }

    /** Starts a motor, 0 for A to 2 for C. */
    public void startMotor(int id) {
        send(OPCODE_SET_MOTOR_ON_OFF, (byte) (1 << id | ON_OR_FORWARD));
    }

    /** Lets a motor roll, 0 for A to 2 for C. */
    public void fltMotor(int id) {
        send(OPCODE_SET_MOTOR_ON_OFF, (byte) (1 << id));
    }

    /** Lets a motor, 0 for A to 2 for C, turn forward once it is started. */
    public void forward(int id) {
        send(OPCODE_SET_MOTOR_DIRECTION, (byte) (1 << id | ON_OR_FORWARD));
    }

    /** Lets a motor, 0 for A to 2 for C, turn backward once it is started. */
    public void backward(int id) {
        send(OPCODE_SET_MOTOR_DIRECTION, (byte) (1 << id));
    }

    /** Lets the link send macros as they are, without what makes them messages. */
    public void setRawMode() {
        sendData(REG_COMMAND, RAW);
    }

    /** Sends at most 16 bytes as they are. */
    public void sendBytes(byte[] data, int len) {
        sendData(REG_DATA, data, len);
        pause();
        sendData(REG_LENGTH, (byte) len);
    }

    /** Reads bytes that the link has heard into the array; gives how many. */
    public int readBytes(byte[] data) {
        int count = Math.min(bytesAvailable(), data.length);
        if (count > 0) {
            pause();
            getData(REG_DATA, data, count);
        }
        return count;
    }

    /** Writes a message into the link's memory, and sends it. */
    public void defineAndRun(byte[] macro, int len) {
        sendData(EEPROM_BUFFER, (byte) len);
        pause();
        sendData(EEPROM_BUFFER + 1, macro, len);
        pause();
        runMacro(EEPROM_BUFFER);
    }

    private void send(byte... message) {
        defineAndRun(message, message.length);
    }

    private int read(int register) {
        one[0] = 0;
        getData(register, one, 1);
        return one[0] & 0xFF;
    }

    private void pause() {
        Delay.msDelay(DELAY);
    }
}

package lejos.nxt.addon;

import lejos.nxt.I2CPort;
import lejos.nxt.I2CSensor;

/** The second infrared seeker of HiTechnic: it sees where infrared light comes from, and tells light that is sent. */
public class IRSeekerV2 extends I2CSensor {
    /** The address of the sensor. */
    public static final byte address = 0x10;

    /** What getAngle gives if there is no light. */
    public static final float noAngle = Float.NaN;

    private static final int REG_ALL = 0x42;
    private static final int REG_AVERAGE = 0x48;
    private static final int REG_SENT = 0x49;
    private static final int EYES = 5;
    private static final int AHEAD = 5;
    private static final int STEP = 30;

    private final byte[] bytes = new byte[1];
    private Mode mode;

    /** Makes the sensor of a port, and says which light it looks for. */
    public IRSeekerV2(I2CPort port, Mode mode) {
        super(port, address, I2CPort.STANDARD_MODE, TYPE_LOWSPEED);
        setMode(mode);
    }

    /** Says which light it looks for. */
    public void setMode(Mode mode) {
        this.mode = mode;
    }

    /** Gives the direction: 1 on the left, 5 ahead, 9 on the right; 0 if there is no light, -1 if no sensor answers. */
    public int getDirection() {
        return read(register());
    }

    /** Gives the direction in degrees to the right, in steps of 30, and says whether to wait for light. */
    public float getAngle(boolean blocking) {
        int direction = getDirection();
        while (direction == 0 && blocking) direction = getDirection();
        return direction == 0 ? noAngle : (direction - AHEAD) * STEP;
    }

    /** Gives the direction in degrees to the right, in steps of 30; noAngle if there is no light. */
    public float getAngle() {
        return getAngle(false);
    }

    /** Says whether there is light. */
    public boolean hasDirection() {
        return getDirection() != 0;
    }

    /** Gives how much light an eye sees, 1 on the left to 5 on the right, from 0 to 255; -1 if none answers. */
    public int getSensorValue(int id) {
        if (id < 1 || id > EYES) {
            throw new IllegalArgumentException("The argument 'id' must be between 1 and 5");
        }
        return read(register() + id);
    }

    /** Gives how much light each eye sees, from the left to the right, from 0 to 255. */
    public int[] getSensorValues() {
        int[] values = new int[EYES];
        for (int eye = 0; eye < EYES; eye++) values[eye] = getSensorValue(eye + 1);
        return values;
    }

    /** Gives how much light the eyes see on average, from 0 to 255; -1 in mode AC and for eyes that are not there. */
    public int getAverage(int id) {
        return mode != Mode.DC || id <= 0 || id > EYES ? -1 : read(REG_AVERAGE);
    }

    /** Gives how much light each eye sees, as a text. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder("(");
        for (int eye = 1; eye <= EYES; eye++) {
            text.append(getSensorValue(eye));
            text.append(eye < EYES ? "," : ")");
        }
        return text.toString();
    }

    private int register() {
        return mode == Mode.AC ? REG_SENT : REG_ALL;
    }

    private int read(int register) {
        return getData(register, bytes, 1) != 0 ? -1 : bytes[0] & 0xFF;
    }

    /** Which light the sensor looks for. */
    public static enum Mode {
        /** Light that is sent: it goes on and off quickly. */
        AC,

        /** All infrared light, also of bulbs. */
        DC
    }
}

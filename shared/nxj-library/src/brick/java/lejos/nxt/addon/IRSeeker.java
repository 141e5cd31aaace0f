package lejos.nxt.addon;

import lejos.nxt.I2CPort;
import lejos.nxt.I2CSensor;

/** The first infrared seeker of HiTechnic: it sees where infrared light comes from. */
public class IRSeeker extends I2CSensor {
    private static final int REG_DIRECTION = 0x42;
    private static final int EYES = 5;

    private final byte[] bytes = new byte[1];

    /** Makes the sensor of a port. */
    public IRSeeker(I2CPort port) {
        super(port);
    }

    /** Gives the direction: 1 on the left, 5 ahead, 9 on the right; 0 if there is no light, -1 if no sensor answers. */
    public int getDirection() {
        return read(REG_DIRECTION);
    }

    /** Gives how much light an eye sees, 1 on the left to 5 on the right, from 0 to 255; -1 if none answers. */
    public int getSensorValue(int id) {
        return id <= 0 || id > EYES ? -1 : read(REG_DIRECTION + id);
    }

    private int read(int register) {
        return getData(register, bytes, 1) != 0 ? -1 : bytes[0] & 0xFF;
    }
}

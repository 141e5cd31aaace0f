package lejos.nxt;

/** A port for a sensor that sends bytes. */
public interface I2CPort extends BasicSensorPort {
    /** The usual speed. */
    int STANDARD_MODE = 0;

    /** The way of LEGO's own sensors. */
    int LEGO_MODE = 1;

    /** Keeps the lines busy. */
    int ALWAYS_ACTIVE = 2;

    /** Does not let go of the lines in between. */
    int NO_RELEASE = 4;

    /** A higher speed. */
    int HIGH_SPEED = 8;

    /** How many bytes there can be in a message. */
    int MAX_IO = 32;

    /** There is no such port. */
    int ERR_INVALID_PORT = -1;

    /** The port is busy. */
    int ERR_BUSY = -2;

    /** The sensor does not answer. */
    int ERR_FAULT = -3;

    /** The message is too long. */
    int ERR_INVALID_LENGTH = -4;

    /** The lines are busy. */
    int ERR_BUS_BUSY = -5;

    /** The message was given up. */
    int ERR_ABORT = -6;

    /** Gets the port ready. */
    void i2cEnable(int mode);

    /** Lets the port rest. */
    void i2cDisable();

    /** Gives 0 if the port is ready, and otherwise what is the matter. */
    int i2cStatus();

    /** Sends bytes to a sensor and waits for its answer; gives how many bytes that has, or below 0 what went wrong. */
    int i2cTransaction(int deviceAddress, byte[] writeBuf, int writeOffset, int writeLen, byte[] readBuf,
            int readOffset, int readLen);
}

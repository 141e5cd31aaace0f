package lejos.nxt;

/** A sensor that sends bytes, each from a place with a number. */
public class I2CSensor implements SensorConstants {
    /** The address of most sensors. */
    protected static final int DEFAULT_I2C_ADDRESS = 0x02;

    /** Where the version is. */
    protected static final byte REG_VERSION = 0x00;

    /** Where the name of the maker is. */
    protected static final byte REG_VENDOR_ID = 0x08;

    /** Where the name of the sensor is. */
    protected static final byte REG_PRODUCT_ID = 0x10;

    /** The port of the sensor. */
    protected I2CPort port;

    /** The address of the sensor. */
    protected int address;

    /** Makes the sensor of a port. */
    public I2CSensor(I2CPort port) {
        this(port, I2CPort.LEGO_MODE);
    }

    /** Makes the sensor of a port that works in a mode. */
    public I2CSensor(I2CPort port, int mode) {
        this(port, DEFAULT_I2C_ADDRESS, mode, TYPE_LOWSPEED);
    }

    /** Makes the sensor of a port with an address, a mode and a type. */
    public I2CSensor(I2CPort port, int address, int mode, int type) {
        this.port = port;
        this.address = address;
        port.setType(type);
        port.i2cEnable(mode);
    }

    /** Reads so many bytes from a place on; gives 0, or below 0 what went wrong. */
    public int getData(int register, byte[] buf, int len) {
        return getData(register, buf, 0, len);
    }

    /** Reads so many bytes from a place on into a part of the array; gives 0, or below 0 what went wrong. */
    public synchronized int getData(int register, byte[] buf, int offset, int len) {
        byte[] request = {(byte) register};
        int status = port.i2cTransaction(address, request, 0, 1, buf, offset, len);
        return status < 0 ? status : status == len ? 0 : -1;
    }

    /** Writes a byte to a place; gives 0, or below 0 what went wrong. */
    public int sendData(int register, byte value) {
        return sendData(register, new byte[] {value}, 0, 1);
    }

    /** Writes so many bytes from a place on; gives 0, or below 0 what went wrong. */
    public int sendData(int register, byte[] buf, int len) {
        return sendData(register, buf, 0, len);
    }

    /** Writes so many bytes of a part of the array from a place on; gives 0, or below 0 what went wrong. */
    public synchronized int sendData(int register, byte[] buf, int offset, int len) {
        if (len >= I2CPort.MAX_IO) throw new IllegalArgumentException();
        byte[] message = new byte[len + 1];
        message[0] = (byte) register;
        System.arraycopy(buf, offset, message, 1, len);
        int status = port.i2cTransaction(address, message, 0, len + 1, null, 0, 0);
        return status < 0 ? status : 0;
    }

    /** Gives the version of the sensor. */
    public String getVersion() {
        return fetchString(REG_VERSION, 8);
    }

    /** Gives the name of the maker. */
    public String getVendorID() {
        return fetchString(REG_VENDOR_ID, 8);
    }

    /** Gives the name of the sensor. */
    public String getProductID() {
        return fetchString(REG_PRODUCT_ID, 8);
    }

    /**
     * Asks the sensor at another address from now on, 0x02 to 0xFE and even.
     *
     * @deprecated give the address to the constructor of the sensor's class.
     */
    @Deprecated
    public void setAddress(int addr) {
        // As leJOS NXJ does, it looks at the address before.
        if ((address & 1) != 0) throw new IllegalArgumentException("Bad address format");
        address = addr;
    }

    /** Gives the address of the sensor. */
    public int getAddress() {
        return address;
    }

    /** Gives the port of the sensor. */
    public I2CPort getPort() {
        return port;
    }

    /** Reads a text of at most so many characters. */
    protected String fetchString(byte register, int len) {
        byte[] bytes = new byte[len];
        if (getData(register, bytes, len) < 0) return "";
        int count = 0;
        while (count < len && bytes[count] != 0) count++;
        return new String(bytes, 0, count);
    }
}

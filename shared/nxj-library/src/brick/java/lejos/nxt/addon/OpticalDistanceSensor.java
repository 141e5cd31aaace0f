package lejos.nxt.addon;

import lejos.nxt.I2CPort;
import lejos.nxt.I2CSensor;
import lejos.robotics.RangeFinder;

/** The optical distance sensor of mindsensors: it measures by infrared light how far away things are, in millimetres. */
public class OpticalDistanceSensor extends I2CSensor implements RangeFinder {
    /** The old module for middle distances. */
    public static final byte GP2D12 = 0x31;

    /** The module for short distances. */
    public static final byte GP2D120 = 0x32;

    /** The module for middle distances, 10 to 80 centimetres; the one here. */
    public static final byte GP2YA21 = 0x33;

    /** The module for long distances. */
    public static final byte GP2YA02 = 0x34;

    /** Another module. */
    public static final byte CUSTOM = 0x35;

    private static final int REG_COMMAND = 0x41;
    private static final int REG_DISTANCE = 0x42;
    private static final int REG_VOLTAGE = 0x44;
    private static final int REG_MODULE = 0x50;
    private static final int REG_CURVE = 0x51;
    private static final int REG_LEAST = 0x52;
    private static final int REG_MOST = 0x54;
    private static final int POINT_BYTES = 4;
    private static final byte SWITCH_OFF = 0x44;
    private static final byte SWITCH_ON = 0x45;
    private static final byte APDA_ON = 0x4E;
    private static final byte APDA_OFF = 0x4F;
    private static final float MILLIMETRES = 10;
    private static final int BYTES = 256;

    private final byte[] bytes = new byte[2];

    /** Makes the sensor of a port, and switches it on. */
    public OpticalDistanceSensor(I2CPort port) {
        this(port, DEFAULT_I2C_ADDRESS);
    }

    /** Makes the sensor of a port, which has another address, and switches it on. */
    public OpticalDistanceSensor(I2CPort port, int address) {
        super(port, address, I2CPort.LEGO_MODE, TYPE_LOWSPEED);
        powerOn();
    }

    /** Says which module the sensor has, such as GP2YA21. */
    public void setSensorModule(byte module) {
        sendData(REG_COMMAND, module);
    }

    /** Gives how far away the thing ahead is, in millimetres. */
    public int getDistance() {
        return getDistLSB();
    }

    /** Gives how far away the thing ahead is, in centimetres. */
    public float getRange() {
        return getDistLSB() / MILLIMETRES;
    }

    /** Gives the same as the only one in an array. */
    public float[] getRanges() {
        return new float[] {getRange()};
    }

    /** Switches the sensor on. */
    public void powerOn() {
        sendData(REG_COMMAND, SWITCH_ON);
    }

    /** Switches the sensor off. */
    public void powerOff() {
        sendData(REG_COMMAND, SWITCH_OFF);
    }

    /** Lets the sensor share its port with others of mindsensors. */
    public void setAPDAOn() {
        sendData(REG_COMMAND, APDA_ON);
    }

    /** Lets the sensor be alone at its port. */
    public void setAPDAOff() {
        sendData(REG_COMMAND, APDA_OFF);
    }

    /** Gives how far away the thing ahead is, in millimetres. */
    public int getDistLSB() {
        return readShort(REG_DISTANCE);
    }

    /** Gives the two bytes behind the lower one of the distance, which mean nothing. */
    public int getDistMSB() {
        return readShort(REG_DISTANCE + 1);
    }

    /** Gives what the module measures, in millivolts. */
    public int getVoltLSB() {
        return readShort(REG_VOLTAGE);
    }

    /** Gives the two bytes behind the lower one of the voltage, which mean nothing. */
    public int getVoltMSB() {
        return readShort(REG_VOLTAGE + 1);
    }

    /** Gives which module the sensor has, such as GP2YA21. */
    public int getSensorModule() {
        return readByte(REG_MODULE);
    }

    /** Gives how many points the curve has by which the sensor calculates. */
    public int getCurveCount() {
        return readByte(REG_CURVE);
    }

    /** Sets how many points the curve has by which the sensor calculates. */
    public void setCurveCount(int value) {
        sendData(REG_CURVE, (byte) value);
    }

    /** Gives the shortest distance, in millimetres. */
    public int getDistMinLSB() {
        return readShort(REG_LEAST);
    }

    /** Sets the shortest distance to a byte. */
    public void setDistMinLSB(int value) {
        writeShort(REG_LEAST, (byte) value);
    }

    /** Gives the two bytes behind the lower one of the shortest distance. */
    public int getDistMinMSB() {
        return readShort(REG_LEAST + 1);
    }

    /** Sets the two bytes behind the lower one of the shortest distance. */
    public void setDistMinMSB(int value) {
        writeShort(REG_LEAST + 1, (byte) value);
    }

    /** Gives the longest distance, in millimetres. */
    public int getDistMaxLSB() {
        return readShort(REG_MOST);
    }

    /** Sets the longest distance to a byte. */
    public void setDistMaxLSB(int value) {
        writeShort(REG_MOST, (byte) value);
    }

    /** Gives the two bytes behind the lower one of the longest distance. */
    public int getDistMaxMSB() {
        return readShort(REG_MOST + 1);
    }

    /** Sets the two bytes behind the lower one of the longest distance. */
    public void setDistMaxMSB(int value) {
        writeShort(REG_MOST + 1, (byte) value);
    }

    /** Gives the millivolts of a point of the curve, 1 to 39. */
    public int getVoltPointLSB(int index) {
        return readShort(point(REG_LEAST, index));
    }

    /** Sets the lower byte of the millivolts of a point of the curve, 1 to 39. */
    public void setVoltPointLSB(int index, int value) {
        sendData(point(REG_LEAST, index), (byte) value);
    }

    /** Gives the two bytes behind the lower one of the millivolts of a point. */
    public int getVoltPointMSB(int index) {
        return readShort(point(REG_LEAST + 1, index));
    }

    /** Sets the two bytes behind the lower one of the millivolts of a point. */
    public void setVoltPointMSB(int index, int value) {
        writeShort(point(REG_LEAST + 1, index), value);
    }

    /** Gives the millimetres of a point of the curve, 1 to 39. */
    public int getDistPointLSB(int index) {
        return readShort(point(REG_MOST, index));
    }

    /** Sets the millimetres of a point of the curve, 1 to 39. */
    public void setDistPointLSB(int index, int value) {
        writeShort(point(REG_MOST, index), value);
    }

    /** Gives the two bytes behind the lower one of the millimetres of a point. */
    public int getDistPointMSB(int index) {
        return readShort(point(REG_MOST + 1, index));
    }

    /** Sets the two bytes behind the lower one of the millimetres of a point. */
    public void setDistPointMSB(int index, int value) {
        writeShort(point(REG_MOST + 1, index), value);
    }

    private static int point(int register, int index) {
        return register + POINT_BYTES * (index == 0 ? 1 : index);
    }

    private int readByte(int register) {
        getData(register, bytes, 1);
        return bytes[0] & 0xFF;
    }

    private int readShort(int register) {
        getData(register, bytes, 2);
        return (bytes[1] & 0xFF) * BYTES + (bytes[0] & 0xFF);
    }

    private void writeShort(int register, int value) {
        bytes[0] = (byte) (value % BYTES);
        bytes[1] = (byte) (value / BYTES);
        sendData(register, bytes, 2);
    }
}

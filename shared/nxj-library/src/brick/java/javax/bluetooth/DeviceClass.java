package javax.bluetooth;

/** The kind of a device, as a number of three parts. */
public class DeviceClass {
    private final int record;

    /** Makes one of the whole number. */
    public DeviceClass(int record) {
        this.record = record;
    }

    /** Gives the bits that say what the device offers. */
    public int getServiceClasses() {
        return record & 0xffe000;
    }

    /** Gives the bits of the kind. */
    public int getMajorDeviceClass() {
        return record & 0x001f00;
    }

    /** Gives the bits that say more of the kind. */
    public int getMinorDeviceClass() {
        return record & 0x0000fc;
    }
}

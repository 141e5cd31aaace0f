package javax.bluetooth;

import lejos.nxt.comm.Bluetooth;

/** This robot, as others see it by Bluetooth. */
public class LocalDevice {
    private static final int KIND = 0x3e0100;

    private static LocalDevice device;

    private LocalDevice() {
    }

    /** Gives this robot. */
    public static LocalDevice getLocalDevice() throws BluetoothStateException {
        if (device == null) device = new LocalDevice();
        return device;
    }

    /** Gives the name of this robot. */
    public String getFriendlyName() {
        return Bluetooth.getFriendlyName();
    }

    /** Gives the address of this robot, which is its name here. */
    public String getBluetoothAddress() {
        return Bluetooth.getLocalAddress();
    }

    /** Gives the kind of device that an NXT says it is. */
    public DeviceClass getDeviceClass() {
        return new DeviceClass(KIND);
    }

    /** Gives true: Bluetooth is always on here. */
    public static boolean isPowerOn() {
        return true;
    }

    /** Gives 1: other robots can always see this one. */
    public int getDiscoverable() {
        return 1;
    }

    /** Gives null. */
    public static String getProperty(String property) {
        return null;
    }
}

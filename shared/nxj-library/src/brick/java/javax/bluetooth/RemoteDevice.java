package javax.bluetooth;

import java.io.IOException;
import javax.microedition.io.Connection;
import lejos.nxt.comm.NXTConnection;

/** Another robot; its address is its name here. */
public class RemoteDevice {
    private String name;
    private String address;
    private int kind;

    /** Makes one of its name; Bluetooth.getKnownDevice gives those that there are. */
    protected RemoteDevice(String addr) {
        name = addr;
        address = addr;
    }

    /** Makes one of a name, an address and the number of its kind. */
    public RemoteDevice(String name, String deviceAddr, int devclass) {
        this.name = name;
        address = deviceAddr;
        kind = devclass;
    }

    /**
     * Gives the robot at the other end of a connection.
     *
     * @throws IllegalArgumentException if it is no connection to a robot.
     */
    public static RemoteDevice getRemoteDevice(Connection conn) throws IOException {
        if (!(conn instanceof NXTConnection)) throw new IllegalArgumentException();
        return new RemoteDevice(((NXTConnection) conn).getAddress());
    }

    /** Gives the name of the robot; the value does not matter. */
    public String getFriendlyName(boolean alwaysAsk) {
        return name;
    }

    /** Sets the name by which this object knows the robot. */
    public void setFriendlyName(String fName) {
        name = fName;
    }

    /** Gives the address of the robot. */
    public String getBluetoothAddress() {
        return address;
    }

    /** Gives the address of the robot. */
    public String getDeviceAddr() {
        return address;
    }

    /** Sets the address by which this object knows the robot. */
    public void setDeviceAddr(String deviceAddr) {
        address = deviceAddr;
    }

    /** Gives the number of the kind of device. */
    public int getDeviceClass() {
        return kind;
    }

    /** Tells whether the robot has a name. */
    public boolean isAuthenticated() {
        return !name.equals("");
    }

    /** Gives false. */
    public boolean isEncrypted() {
        return false;
    }

    /** Tells whether both have the same address. */
    public boolean equals(Object obj) {
        return obj instanceof RemoteDevice && ((RemoteDevice) obj).address.equals(address);
    }

    /** Gives a number that is the same for the same address. */
    public int hashCode() {
        return address.hashCode();
    }
}

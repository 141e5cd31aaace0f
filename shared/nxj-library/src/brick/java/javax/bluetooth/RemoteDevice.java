package javax.bluetooth;

/** Another robot, by its name. */
public class RemoteDevice {
    private final String name;

    /** Makes one of its name; Bluetooth.getKnownDevice gives those that there are. */
    protected RemoteDevice(String name) {
        this.name = name;
    }

    /** Gives the name of the robot; the value does not matter. */
    public String getFriendlyName(boolean alwaysAsk) {
        return name;
    }

    /** Gives the address of the robot, which is its name here. */
    public final String getBluetoothAddress() {
        return name;
    }

    /** Says whether both are the same robot. */
    public boolean equals(Object other) {
        return other instanceof RemoteDevice && ((RemoteDevice) other).name.equals(name);
    }

    /** Gives a number that is the same for the same robot. */
    public int hashCode() {
        return name.hashCode();
    }
}

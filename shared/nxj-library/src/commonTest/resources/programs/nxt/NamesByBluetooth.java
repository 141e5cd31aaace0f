import java.io.IOException;
import javax.bluetooth.BluetoothStateException;
import javax.bluetooth.DeviceClass;
import javax.bluetooth.LocalDevice;
import javax.bluetooth.RemoteDevice;
import javax.microedition.io.Connection;
import javax.microedition.io.Connector;
import javax.microedition.io.StreamConnection;
import javax.microedition.io.StreamConnectionNotifier;
import lejos.nxt.comm.Bluetooth;
import lejos.util.Datalogger;

/** What javax.bluetooth and javax.microedition.io tell when there is no other robot. */
public class NamesByBluetooth {
    public static void main(String[] arguments) throws IOException {
        LocalDevice local = LocalDevice.getLocalDevice();
        System.out.println(local == LocalDevice.getLocalDevice()); // expect true
        System.out.println(local.getFriendlyName().equals(Bluetooth.getFriendlyName())); // expect true
        System.out.println(local.getBluetoothAddress().equals(Bluetooth.getLocalAddress())); // expect true
        DeviceClass kind = local.getDeviceClass();
        System.out.println(kind.getMajorDeviceClass() + " " + kind.getMinorDeviceClass() + " " + LocalDevice.isPowerOn()); // expect 256 0 true

        RemoteDevice other = new RemoteDevice("Bob", "00165301", 0x804);
        other.setFriendlyName("Rob");
        System.out.println(other.getFriendlyName(false) + " " + other.getDeviceAddr() + " " + other.getDeviceClass()); // expect Rob 00165301 2052
        System.out.println(other.equals(new RemoteDevice("Eve", "00165301", 0)) + " " + other.isAuthenticated()); // expect true true

        Connection connection = Connector.open("btspp://Nobody;master=true", Connector.READ_WRITE);
        StreamConnection stream = ((StreamConnectionNotifier) connection).acceptAndOpen();
        System.out.println(stream); // expect null
        try {
            Connector.open("http://nobody");
        } catch (IOException e) {
            System.out.println(e.getMessage()); // expect http not a known protocol
        }
        try {
            Connector.openInputStream("btspp://Nobody");
        } catch (ClassCastException e) {
            System.out.println("no stream"); // expect no stream
        }
        System.out.println(new BluetoothStateException("off").getMessage()); // expect off

        Datalogger log = new Datalogger();
        log.writeLog(1);
        log.writeLog(1, 2, 3, 4);
    }
}

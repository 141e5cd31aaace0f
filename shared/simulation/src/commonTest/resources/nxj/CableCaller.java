import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.nxt.comm.NXTCommConnector;
import lejos.nxt.comm.NXTConnection;
import lejos.nxt.comm.RS485;
import lejos.nxt.comm.USB;
import lejos.util.Delay;

/** Sends numbers by cable to the robot called red, and shows what comes back. */
public class CableCaller {
    public static void main(String[] arguments) throws IOException {
        System.out.println(USB.getConnector().connect("red", NXTConnection.RAW) == null);
        NXTCommConnector cable = RS485.getConnector();
        System.out.println(cable.connect("nobody", NXTConnection.PACKET) == null);
        NXTConnection connection = cable.connect("red", NXTConnection.PACKET);
        System.out.println(connection.getAddress() + " " + (RS485.waitForConnection(10, 0) == null));
        DataOutputStream out = connection.openDataOutputStream();
        DataInputStream in = connection.openDataInputStream();
        for (int number = 1; number <= 3; number++) {
            out.writeInt(number);
            out.flush();
            System.out.println(in.readInt());
        }
        connection.close();
        System.out.println(connection.available());
        Delay.msDelay(100000);
    }
}

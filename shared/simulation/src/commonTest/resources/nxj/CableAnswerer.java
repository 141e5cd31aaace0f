import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import lejos.nxt.comm.NXTConnection;
import lejos.nxt.comm.RS485;
import lejos.util.Delay;

/** Waits for another robot at the cable, and sends the square of each number back. */
public class CableAnswerer {
    public static void main(String[] arguments) throws IOException {
        NXTConnection connection = RS485.getConnector().waitForConnection(0, NXTConnection.PACKET);
        DataInputStream in = connection.openDataInputStream();
        DataOutputStream out = connection.openDataOutputStream();
        System.out.println(connection.getAddress().length() > 0);
        try {
            while (true) {
                int number = in.readInt();
                out.writeInt(number * number);
                out.flush();
            }
        } catch (EOFException e) {
            System.out.println("end");
        }
        connection.close();
        Delay.msDelay(100000);
    }
}

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.nxt.Motor;
import lejos.nxt.comm.BTConnection;
import lejos.nxt.comm.Bluetooth;

/** Answers each number with its square, and turns a motor as often. */
public class Answerer {
    public static void main(String[] arguments) throws IOException {
        BTConnection connection = Bluetooth.waitForConnection();
        DataInputStream in = connection.openDataInputStream();
        DataOutputStream out = connection.openDataOutputStream();
        for (int count = 0; count < 3; count++) {
            int number = in.readInt();
            Motor.A.rotate(10 * number);
            out.writeInt(number * number);
            out.flush();
        }
    }
}

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.nxt.LCD;
import lejos.nxt.comm.BTConnection;
import lejos.nxt.comm.Bluetooth;
import lejos.nxt.comm.NXTConnection;
import lejos.util.Delay;

/** Sends numbers to the robot called red, and shows what comes back. */
public class Caller {
    public static void main(String[] arguments) throws IOException {
        BTConnection connection = Bluetooth.connect("red", NXTConnection.PACKET);
        DataOutputStream out = connection.openDataOutputStream();
        DataInputStream in = connection.openDataInputStream();
        for (int number = 1; number <= 3; number++) {
            out.writeInt(number);
            out.flush();
            LCD.drawInt(in.readInt(), 0, number);
        }
        connection.close();
        LCD.refresh();
        Delay.msDelay(1000);
    }
}

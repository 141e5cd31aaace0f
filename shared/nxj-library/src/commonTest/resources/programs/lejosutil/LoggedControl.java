import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import lejos.util.LogColumn;
import lejos.util.NXTDataLogger;
import lejos.util.PIDController;

/** A controller writes a row of a log in each call from the fifth one on, if nobody has set the columns. */
public class LoggedControl {
    public static void main(String[] arguments) throws Exception {
        PIDController controller = new PIDController(100, 10);
        NXTDataLogger logger = new NXTDataLogger();
        System.out.println(controller.registerDataLogger(logger) + " " + logger.getColumns().length); // expect true 8
        System.out.println(controller.registerDataLogger(logger)); // expect false
        for (int i = 1; i <= 7; i++) controller.doPID(90 + i);
        System.out.println(controller.deregisterDataLogger() == logger); // expect true
        controller.doPID(98);
        ByteArrayOutputStream sent = new ByteArrayOutputStream();
        logger.sendCache(new DataOutputStream(sent), new DataInputStream(new ByteArrayInputStream(new byte[0])));
        byte[] bytes = sent.toByteArray();
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes));
        // A row has nine values of 4 bytes, and two commands of 6 bytes where the type changes.
        int row = 9 * 4 + 12;
        in.skip(bytes.length - 6 - 3 * row);
        for (int i = 0; i < 3; i++) {
            in.skip(4);
            System.out.print(in.readInt() + " " + in.readInt() + " " + in.readInt() + " ");
            in.skip(6 + 12 + 6);
            System.out.println(in.readInt());
            in.skip(4);
        }
        // expect 100 5 95 5
        // expect 100 4 96 4
        // expect 100 3 97 3
        NXTDataLogger live = new NXTDataLogger();
        ByteArrayOutputStream now = new ByteArrayOutputStream();
        live.startRealtimeLog(new DataOutputStream(now), new DataInputStream(new ByteArrayInputStream(new byte[0])));
        live.setColumns(new LogColumn[] {new LogColumn("x", LogColumn.DT_BOOLEAN)});
        int before = now.size();
        Thread.sleep(5);
        live.writeLog(true);
        live.writeComment("here");
        live.finishLine();
        System.out.println(now.size() - before); // expect 32
        try {
            live.writeLog(7);
        } catch (IllegalStateException e) {
            System.out.println(e.getMessage()); // expect datatyp mismatch 
        }
    }
}

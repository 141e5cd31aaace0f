import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.util.LogColumn;
import lejos.util.NXTDataLogger;

/** Rows of values in the memory of a logger, and as it sends them. */
public class LoggedRows {
    static DataInputStream in;

    /** Reads commands, and tells of the next one that is not about the type of values. */
    static int command() throws IOException {
        while (true) {
            byte[] head = new byte[4];
            in.readFully(head);
            byte sum = (byte) (head[0] + head[1] + head[2]);
            if (head[0] != -1 || head[1] != (byte) 0xab || head[3] != (byte) ~sum) throw new IOException("no command");
            int command = in.read();
            int value = in.read();
            if (command != 1) return 1000 * command + value;
        }
    }

    static String text() throws IOException {
        StringBuilder text = new StringBuilder();
        int count = 0;
        for (int letter = in.read(); letter != 0; letter = in.read(), count++) text.append((char) letter);
        for (count++; count % 4 != 0; count++) in.read();
        return text.toString();
    }

    static String failure(NXTDataLogger logger, LogColumn[] columns) {
        try {
            if (columns == null) logger.finishLine();
            else logger.setColumns(columns);
            return "none";
        } catch (IllegalStateException e) {
            return e.getMessage();
        } catch (UnsupportedOperationException e) {
            return e.getMessage();
        } catch (IOException e) {
            return "lost";
        }
    }

    public static void main(String[] arguments) throws Exception {
        NXTDataLogger logger = new NXTDataLogger();
        LogColumn[] columns = {new LogColumn("way", LogColumn.DT_INTEGER), new LogColumn("light!", LogColumn.DT_DOUBLE, 2)};
        System.out.println(logger.getColumns() == null); // expect true
        logger.setColumns(columns);
        System.out.println(logger.getColumns().length + " " + failure(logger, columns)); // expect 2 already called
        System.out.println(failure(logger, null)); // expect too few cols 
        for (int i = 1; i <= 200; i++) {
            logger.writeLog(10 * i);
            logger.writeLog(i / 4.0);
            Thread.sleep(2);
            logger.finishLine();
        }
        ByteArrayOutputStream sent = new ByteArrayOutputStream();
        logger.sendCache(new DataOutputStream(sent), new DataInputStream(new ByteArrayInputStream(new byte[0])));
        logger.stopLogging();
        in = new DataInputStream(new ByteArrayInputStream(sent.toByteArray()));
        System.out.println(command() + " " + text() + " " + text() + " " + text()); // expect 2003 milliseconds!y!1 way!y!1 light !y!2
        // Each row has 4 + 4 + 8 bytes, and commands of 6 bytes before the values of another type; two more are at the end.
        int size = sent.toByteArray().length;
        System.out.println(size - 6 - 16 - 12 - 12); // expect 5612
        int rows = 0;
        double last = 0;
        int way = 0;
        while (rows < 200) {
            in.readInt();
            way = in.readInt();
            in.skip(6);
            last = in.readDouble();
            if (++rows < 200) in.skip(6);
        }
        System.out.println(way + " " + last + " " + command()); // expect 2000 50.0 3255
        System.out.println(new LogColumn("b", LogColumn.DT_BOOLEAN, false).isChartable() + " " + columns[1].getRangeAxisID()); // expect false 2
        System.out.println(columns[1].getSize() + " " + columns[0].getSize() + " " + columns[0].getDatatype()); // expect 8 4 3
    }
}

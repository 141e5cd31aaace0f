import java.io.BufferedWriter;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.util.Properties;

// only here
public class LinesOfABrick {
    public static void main(String[] arguments) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        BufferedWriter writer = new BufferedWriter(bytes);
        writer.write("ab");
        writer.newLine();
        writer.close();
        System.out.println(bytes.size() + " " + bytes.toByteArray()[2]); // expect 4 13
        bytes.reset();
        Properties settings = new Properties();
        settings.setProperty("a", "1");
        settings.store(bytes, "robot");
        System.out.println(bytes.toString().replace('\r', '/').replace('\n', '/')); // expect #robot//a=1//
        bytes.reset();
        settings.list(new PrintStream(bytes));
        System.out.println(bytes.toString().replace('\n', '/')); // expect - properties -/a=1/
    }
}

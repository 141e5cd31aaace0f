import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.PrintStream;

public class LinesAndPrinting {
    public static void main(String[] arguments) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PrintStream printer = new PrintStream(bytes);
        printer.print("a");
        printer.print(1);
        printer.print(2.5);
        printer.print('c');
        printer.print(true);
        printer.print(7L);
        printer.print((Object) null);
        printer.print(new char[] {'x', 'y'});
        printer.flush();
        System.out.println(bytes.toString()); // expect a12.5ctrue7nullxy
        InputStream lines = new ByteArrayInputStream("first\nsecond\r\n\nlast".getBytes());
        BufferedReader reader = new BufferedReader(new InputStreamReader(lines));
        for (String line = reader.readLine(); line != null; line = reader.readLine()) System.out.println("[" + line + "]"); // expect [first]
        // expect [second]
        // expect []
        // expect [last]
        reader.close();
        InputStream input = new ByteArrayInputStream(new byte[] {1, 2, 3, 4, 5});
        byte[] part = new byte[3];
        System.out.println(input.read(part) + " " + part[2] + " " + input.skip(1) + " " + input.read() + " " + input.read()); // expect 3 3 1 5 -1
        System.out.print("in ");
        System.out.print("one ");
        System.out.println("line"); // expect in one line
    }
}

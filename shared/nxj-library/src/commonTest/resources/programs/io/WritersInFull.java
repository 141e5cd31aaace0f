import java.io.BufferedWriter;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInput;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.io.Reader;
import java.io.UnsupportedEncodingException;
import java.io.Writer;

public class WritersInFull {
    static class Spy extends ByteArrayOutputStream {
        int room() {
            return buf.length - count;
        }
    }

    public static void main(String[] arguments) throws IOException {
        Spy bytes = new Spy();
        Writer writer = new BufferedWriter(new OutputStreamWriter(bytes, "utf-8"));
        writer.append('a').append("bc").append("xdey", 1, 3).append("\u00e9\u20ac");
        writer.flush();
        System.out.println(bytes.size() + " " + (bytes.room() >= 0)); // expect 10 true
        Reader reader = new InputStreamReader(new ByteArrayInputStream(bytes.toByteArray()), "UTF-8");
        System.out.println(reader.skip(3) + " " + (char) reader.read() + " " + reader.markSupported()); // expect 3 d false
        System.out.println((char) reader.read() + " " + reader.read() + " " + reader.read() + " " + reader.read()); // expect e 233 8364 -1
        try {
            reader.reset();
        } catch (IOException wrong) {
            System.out.println("no way back"); // expect no way back
        }
        try {
            new InputStreamReader(null, "morse");
        } catch (UnsupportedEncodingException wrong) {
            System.out.println("no morse"); // expect no morse
        } catch (NullPointerException wrong) {
            System.out.println("no morse");
        }
        System.out.println(bytes.toString("iso-8859-1").substring(0, 5)); // expect abcde
        bytes.reset();
        DataOutputStream data = new DataOutputStream(bytes);
        data.writeUTF("one");
        data.writeBytes("line 1\r\nline 2");
        DataInput in = new DataInputStream(new ByteArrayInputStream(bytes.toByteArray()));
        System.out.println(DataInputStream.readUTF(in) + " " + in.readLine() + " " + in.readLine() + " " + in.readLine()); // expect one line 1 line 2 null
        bytes.reset();
        bytes.write(65);
        System.out.println(bytes.toString(1).charAt(0) == 'A' + 256); // expect true
    }
}

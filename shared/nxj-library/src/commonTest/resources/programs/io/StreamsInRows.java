import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.BufferedWriter;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;

public class StreamsInRows {
    /** Writes each byte twice. */
    static class Doubling extends FilterOutputStream {
        Doubling(OutputStream out) {
            super(out);
        }

        @Override
        public void write(int value) throws IOException {
            out.write(value);
            out.write(value);
        }
    }

    public static void main(String[] arguments) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        OutputStream output = new BufferedOutputStream(new Doubling(bytes), 4);
        output.write("robot".getBytes());
        output.write(new byte[] {'x', 'y', 'z'}, 1, 1);
        output.flush();
        System.out.println(bytes.toString()); // expect rroobboottyy
        InputStream input = new BufferedInputStream(new ByteArrayInputStream(bytes.toByteArray()), 3);
        int sum = 0;
        for (int value = input.read(); value >= 0; value = input.read()) sum = sum * 3 + value;
        System.out.println(sum); // expect 30165820
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        Writer writer = new BufferedWriter(new OutputStreamWriter(text));
        writer.write("one");
        writer.write(' ');
        writer.write(new char[] {'t', 'w', 'o'});
        writer.close();
        System.out.println(text.toString() + " " + text.size()); // expect one two 7
        try {
            throw new IOException("broken");
        } catch (IOException wrong) {
            System.out.println(wrong.getMessage()); // expect broken
        }
    }
}

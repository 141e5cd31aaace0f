import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import josx.platform.rcx.LCD;

public class PartsOfArrays {
    static final byte[] paper = new byte[20];
    static int written = 0;
    static int read = 0;

    static class Writer extends OutputStream {
        public void write(int value) {
            paper[written++] = (byte) value;
        }
    }

    static class Reader extends InputStream {
        public int read() {
            return read == written ? -1 : paper[read++];
        }
    }

    public static void main(String[] arguments) throws IOException {
        byte[] bytes = {1, 2, 3, 4, 5};
        OutputStream out = new Writer();
        out.write(bytes, 1, 3);
        out.write(bytes);
        out.flush();
        out.close();
        DataOutputStream data = new DataOutputStream(out);
        data.write(bytes, 4, 1);
        LCD.showNumber(data.size()); // shows: 1
        LCD.showNumber(written); // shows: 9
        InputStream in = new Reader();
        LCD.showNumber(in.available()); // shows: 0
        byte[] copy = new byte[10];
        LCD.showNumber(in.read(copy, 5, 3)); // shows: 3
        LCD.showNumber(copy[5] * 100 + copy[6] * 10 + copy[7]); // shows: 234
        LCD.showNumber(new DataInputStream(in).read(copy, 0, 10)); // shows: 6
        LCD.showNumber(copy[0] * 10 + copy[5]); // shows: 15
        read = 3;
        LCD.showNumber((int) in.skip(2)); // shows: 2
        LCD.showNumber(in.read()); // shows: 3
        LCD.showNumber((int) new DataInputStream(in).skip(100)); // shows: 3
        LCD.showNumber((int) in.skip(-1)); // shows: 0
        LCD.showNumber(in.markSupported() ? 1 : 0); // shows: 0
        in.mark(10);
        try {
            in.reset();
        } catch (IOException impossible) {
            LCD.showNumber(8); // shows: 8
        }
        in.close();
    }
}

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import josx.platform.rcx.LCD;

public class DataStreams {
    static final byte[] paper = new byte[40];
    static int written = 0;
    static int read = 0;

    static class Writer extends OutputStream {
        public void write(int value) {
            paper[written++] = (byte) value;
        }
    }

    static class Reader extends InputStream {
        public int read() {
            return read == written ? -1 : paper[read++] & 0xFF;
        }

        public int available() {
            return written - read;
        }
    }

    public static void main(String[] arguments) throws IOException {
        DataOutputStream out = new DataOutputStream(new Writer());
        out.write(250);
        out.writeBoolean(true);
        out.writeByte(-3);
        out.writeShort(-300);
        out.writeChar('Z');
        out.writeInt(123456);
        out.writeFloat(2.5f);
        out.write(new byte[] {1, 2, 3});
        out.flush();
        out.close();
        LCD.showNumber(out.size()); // shows: 18
        DataInputStream in = new DataInputStream(new Reader());
        LCD.showNumber(in.available()); // shows: 18
        LCD.showNumber(in.read()); // shows: 250
        LCD.showNumber(in.readBoolean() ? 1 : 0); // shows: 1
        LCD.showNumber(-in.readByte()); // shows: 3
        LCD.showNumber(-in.readShort()); // shows: 300
        LCD.showNumber(in.readChar()); // shows: 90
        LCD.showNumber(in.readInt() / 100); // shows: 1234
        LCD.showNumber((int) (in.readFloat() * 10)); // shows: 25
        byte[] rest = new byte[5];
        LCD.showNumber(in.read(rest)); // shows: 3
        LCD.showNumber(rest[2]); // shows: 3
        LCD.showNumber(-in.read(rest)); // shows: 1
        try {
            in.readInt();
        } catch (IOException over) {
            LCD.showNumber(7); // shows: 7
        }
        in.close();
    }
}

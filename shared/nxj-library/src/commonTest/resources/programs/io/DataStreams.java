import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;

public class DataStreams {
    public static void main(String[] arguments) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream output = new DataOutputStream(bytes);
        output.writeInt(-123456);
        output.writeLong(1L << 50);
        output.writeDouble(Math.PI);
        output.writeFloat(2.5f);
        output.writeUTF("text \u00e4");
        output.writeBoolean(true);
        output.writeShort(-2);
        output.writeByte(200);
        output.writeChar('x');
        output.flush();
        byte[] written = bytes.toByteArray();
        System.out.println(written.length + " " + bytes.size()); // expect 39 39
        int sum = 0;
        for (byte one : written) sum += one;
        System.out.println(sum); // expect 785
        DataInputStream input = new DataInputStream(new ByteArrayInputStream(written));
        System.out.println(input.readInt() + " " + input.readLong() + " " + (input.readDouble() == Math.PI) + " " + input.readFloat());
        // expect -123456 1125899906842624 true 2.5
        System.out.println(input.readUTF().length() + " " + input.readBoolean() + " " + input.readShort()); // expect 6 true -2
        System.out.println(input.readUnsignedByte() + " " + input.readChar() + " " + input.available()); // expect 200 x 0
        System.out.println(input.read()); // expect -1
        try {
            input.readInt();
        } catch (EOFException end) {
            System.out.println("end"); // expect end
        }
    }
}

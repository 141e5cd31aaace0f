import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.FileInputStream;
import java.io.FileNotFoundException;
import java.io.FileOutputStream;
import java.io.IOException;

// only here
public class FilesOnTheBrick {
    public static void main(String[] arguments) throws IOException {
        File file = new File("log.dat");
        System.out.println(file.exists() + " " + file.getName()); // expect false log.dat
        DataOutputStream output = new DataOutputStream(new FileOutputStream(file));
        for (int i = 0; i < 5; i++) {
            output.writeInt(i * i);
            output.writeUTF("line " + i);
        }
        output.close();
        System.out.println(file.exists() + " " + file.length()); // expect true 60
        DataInputStream input = new DataInputStream(new FileInputStream(file));
        int sum = 0;
        String last = null;
        for (int i = 0; i < 5; i++) {
            sum += input.readInt();
            last = input.readUTF();
        }
        input.close();
        System.out.println(sum + " " + last); // expect 30 line 4
        FileOutputStream more = new FileOutputStream(file, true);
        more.write(7);
        more.close();
        File[] all = File.listFiles();
        System.out.println(file.length() + " " + all[0].getName() + " " + all[1]); // expect 61 log.dat null
        System.out.println(file.delete() + " " + file.exists()); // expect true false
        try {
            new FileInputStream(file);
        } catch (FileNotFoundException wrong) {
            System.out.println("not there"); // expect not there
        }
    }
}

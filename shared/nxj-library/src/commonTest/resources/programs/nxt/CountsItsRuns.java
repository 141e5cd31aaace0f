import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;

// only here
public class CountsItsRuns {
    public static void main(String[] arguments) throws IOException {
        File file = new File("runs.dat");
        int runs = 0;
        if (file.exists()) {
            DataInputStream in = new DataInputStream(new FileInputStream(file));
            runs = in.readInt();
            in.close();
        }
        DataOutputStream out = new DataOutputStream(new FileOutputStream(file));
        out.writeInt(runs + 1);
        out.close();
        System.out.println("run " + (runs + 1)); // expect run 1
    }
}

import java.io.File;
import java.io.FileInputStream;
import java.io.FileNotFoundException;
import java.io.FileOutputStream;
import java.io.IOException;
import lejos.nxt.FlashError;

/** Far more fits into a file than into the memory for objects. */
public class RoomInFlash {
    public static void main(String[] arguments) throws IOException {
        long before = Runtime.getRuntime().freeMemory();
        FileOutputStream out = new FileOutputStream(new File("big.txt"));
        byte[] line = new byte[250];
        for (int i = 0; i < line.length; i++) line[i] = (byte) i;
        for (int i = 0; i < 320; i++) out.write(line);
        out.close();
        System.out.println(new File("big.txt").length() + " " + File.freeMemory()); // expect 80000 50176
        FileInputStream in = new FileInputStream(new File("big.txt"));
        int sum = 0;
        byte[] some = new byte[1000];
        for (int count = in.read(some); count > 0; count = in.read(some)) sum += count + some[7];
        System.out.println(sum); // expect 80560
        System.out.println(before - Runtime.getRuntime().freeMemory() < 8000); // expect true
        FileOutputStream more = new FileOutputStream(new File("more.txt"));
        int pages = 0;
        try {
            while (true) {
                for (int i = 0; i < 256; i++) more.write(i);
                pages++;
            }
        } catch (FlashError full) {
            System.out.println(pages); // expect 196
        }
        File.format();
        int count = 0;
        try {
            while (true) {
                new FileOutputStream(new File("file" + count + ".txt")).close();
                count++;
            }
        } catch (FileNotFoundException full) {
            System.out.println(count + " " + full.getMessage() + " " + File.totalFiles); // expect 14 file could not be created 14
        }
    }
}

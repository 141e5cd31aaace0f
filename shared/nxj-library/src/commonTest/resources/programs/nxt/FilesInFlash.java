import java.io.File;
import java.io.FileInputStream;
import java.io.FileNotFoundException;
import java.io.FileOutputStream;
import java.io.IOException;
import lejos.nxt.Flash;
import lejos.nxt.FlashError;

public class FilesInFlash {
    static void write(String name, int count, int value) throws IOException {
        FileOutputStream out = new FileOutputStream(new File(name));
        for (int i = 0; i < count; i++) out.write(value + i);
        out.close();
    }

    static String all() {
        String told = "";
        for (File file : File.listFiles()) {
            if (file != null) told += file + ":" + file.length() + "@" + file.getPage() + " ";
        }
        return told.trim();
    }

    public static void main(String[] arguments) throws IOException {
        System.out.println(File.freeMemory() + " " + File.totalFiles + " " + File.listFiles().length); // expect 131072 0 30
        write("a", 300, 0);
        write("b", 10, 5);
        System.out.println(all() + " " + File.freeMemory()); // expect a:300@3 b:10@5 129536
        FileOutputStream more = new FileOutputStream(new File("a"), true);
        more.write(99);
        more.close();
        System.out.println(all()); // expect b:10@5 a:301@6
        FileInputStream in = new FileInputStream(new File("a"));
        System.out.println(in.available() + " " + in.skip(299) + " " + in.read() + " " + in.read() + " " + in.read()); // expect 301 0 43 99 -1
        File.defrag();
        System.out.println(all() + " " + new File("b").getIndex() + " " + File.totalFiles); // expect b:10@3 a:301@4 0 2
        FileOutputStream lost = new FileOutputStream(new File("c"));
        lost.write(1);
        File.reset();
        System.out.println(new File("c").length() + " " + new File("c").exists()); // expect 0 true
        System.out.println(new File("b").delete() + " " + new File("b").exists() + " " + new File("none").delete()); // expect true false false
        System.out.println(all()); // expect a:301@4 c:0@6
        try {
            new FileInputStream(new File("none"));
        } catch (FileNotFoundException wrong) {
            System.out.println(wrong.getMessage()); // expect none does not exist
        }
        File hidden = new File("c");
        System.out.println(hidden.canRead() + " " + hidden.canWrite() + " " + hidden.setReadOnly() + " " + hidden.canWrite() + " " + hidden.isHidden()); // expect true true true false false
        File.format();
        System.out.println(File.listFiles()[0] + " " + File.totalFiles); // expect null 0
        try {
            Flash.writePage(new byte[256], Flash.MAX_USER_PAGES);
        } catch (FlashError full) {
            System.out.println("no such page"); // expect no such page
        }
        System.out.println(new File("x").equals(new File("x"))); // expect false
    }
}

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Enumeration;
import java.util.Properties;

public class PropertiesInLines {
    public static void main(String[] arguments) throws IOException {
        String text = "# a comment\n  ! another\n\nspeed = 20\r\nname:Rob\\\n   otran\nempty\nkey\\ with\\ blanks  value\nsign=\\u0041\\tB\\=\n";
        Properties read = new Properties();
        read.load(new ByteArrayInputStream(text.getBytes()));
        System.out.println(read.getProperty("speed") + " " + read.getProperty("name") + " [" + read.getProperty("empty") + "]"); // expect 20 Robotran []
        System.out.println(read.getProperty("key with blanks") + " " + read.getProperty("sign")); // expect value A	B=
        Properties more = new Properties(read);
        more.setProperty("own", "1");
        int count = 0;
        for (Enumeration<?> names = more.propertyNames(); names.hasMoreElements(); names.nextElement()) count++;
        System.out.println(count + " " + more.getProperty("speed") + " " + more.getProperty("none", "-")); // expect 6 20 -
        Properties written = new Properties();
        written.setProperty("a b", " x:\u00e9");
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        written.store(out, null);
        String line = out.toString();
        System.out.println(line.substring(line.lastIndexOf("a")).trim()); // expect a\ b=\ x\:\u00E9
    }
}

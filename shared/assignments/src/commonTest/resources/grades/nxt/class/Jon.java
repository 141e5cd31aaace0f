import java.io.File;
import java.net.Socket;

public class Jon {
    public static void main(String[] args) throws Exception {
        new Socket("localhost", 80).close();
        new File("/etc/passwd").delete();
    }
}

import java.util.ArrayList;

public class NoCollections {
    public static void main(String[] arguments) {
        ArrayList list = new ArrayList();
        list.add("a");
    }
}
// error 1
// error 5

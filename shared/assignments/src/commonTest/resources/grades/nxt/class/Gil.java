import java.util.ArrayList;
import java.util.List;

public class Gil {
    public static void main(String[] args) {
        List<long[]> all = new ArrayList<long[]>();
        while (true) {
            try {
                all.add(new long[1000]);
            } catch (Throwable full) {
                all.add(null);
            }
        }
    }
}

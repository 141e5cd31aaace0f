public class Hog {
    public static void main(String[] args) {
        Object[] all = new Object[1000];
        while (true) {
            for (int i = 0; i < 1000; i++) {
                all[i] = new int[100];
            }
        }
    }
}

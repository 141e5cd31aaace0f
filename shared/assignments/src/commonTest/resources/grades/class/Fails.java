public class Fails {
    public static void main(String[] args) {
        int[] none = null;
        none[3] = 1;
    }
}

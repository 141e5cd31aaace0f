public class Ida {
    public static void main(String[] args) {
        System.out.println(deep(1));
    }

    static long deep(long n) {
        return deep(n + 1) + 1;
    }
}

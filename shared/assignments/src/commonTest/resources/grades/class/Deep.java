public class Deep {
    public static void main(String[] args) {
        deep(1);
    }

    static int deep(int n) {
        return deep(n + 1) + 1;
    }
}

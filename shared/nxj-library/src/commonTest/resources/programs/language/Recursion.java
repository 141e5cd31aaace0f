public class Recursion {
    static int factorial(int n) {
        return n < 2 ? 1 : n * factorial(n - 1);
    }

    static int fibonacci(int n) {
        return n < 2 ? n : fibonacci(n - 1) + fibonacci(n - 2);
    }

    static boolean isEven(int n) {
        return n == 0 || isOdd(n - 1);
    }

    static boolean isOdd(int n) {
        return n != 0 && isEven(n - 1);
    }

    public static void main(String[] arguments) {
        System.out.println(factorial(7)); // expect 5040
        System.out.println(fibonacci(10)); // expect 55
        System.out.println(isEven(10) ? 1 : 0); // expect 1
    }
}

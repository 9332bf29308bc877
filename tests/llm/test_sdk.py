"""Where keys and SDKs are found, and what is said when they are not."""

from __future__ import annotations

import pytest

from missiontree.llm.chat import ProviderError
from missiontree.llm.sdk import Sdk

SDK = Sdk("Somebody", "json", "somebody", ("SOMEBODY_API_KEY", "OTHER_API_KEY"))


def test_a_key_that_is_handed_in_goes_before_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOMEBODY_API_KEY", "first")
    assert SDK.key("given") == "given"
    assert SDK.key() == "first"


def test_variables_are_asked_in_order_and_blank_ones_are_not_set(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOMEBODY_API_KEY", " \n")
    monkeypatch.setenv("OTHER_API_KEY", " second\n")
    assert SDK.key("") == "second"


def test_without_a_key_every_variable_is_named() -> None:
    with pytest.raises(ProviderError, match="no key for Somebody") as fault:
        SDK.key()
    assert fault.value.kind == "unauthorised"
    assert fault.value.hint == "Set the environment variable SOMEBODY_API_KEY or OTHER_API_KEY."


@pytest.mark.parametrize("key", ["a b", "a\nb", "schlüssel", "a\x00b"])
def test_what_can_be_no_key_is_refused_and_not_shown(key: str) -> None:
    """In a header it would raise deep inside an HTTP library, which quotes it."""
    with pytest.raises(ProviderError) as fault:
        SDK.key(key)
    assert fault.value.kind == "unauthorised"
    assert key not in str(fault.value) + fault.value.hint


def test_a_module_is_loaded_and_so_is_one_below_it() -> None:
    assert SDK.load().dumps({}) == "{}"
    assert SDK.load("decoder").JSONDecodeError


def test_a_module_that_is_missing_says_what_to_install() -> None:
    with pytest.raises(ProviderError, match="no_such_module is missing") as fault:
        Sdk("Somebody", "no_such_module", "somebody", ()).load()
    assert (fault.value.kind, fault.value.hint) == ("not_installed", "pip install 'missiontree[somebody]'")


@pytest.mark.parametrize("url", ["http://127.0.0.1:8000", "https://x.example/v1", "http://u:p@x.example"])
def test_an_address_is_taken_as_it_is(url: str) -> None:
    assert SDK.address(url) == url


@pytest.mark.parametrize("url", [None, ""])
def test_no_address_is_the_providers_own(url: str | None) -> None:
    assert SDK.address(url) is None


@pytest.mark.parametrize("url", ["nonsense", "ftp://x", "http://", "http://[x", "http://x:99999999", "https://x:0"])
def test_an_address_that_is_none_is_refused(url: str) -> None:
    with pytest.raises(ProviderError, match="base URL for Somebody is no address") as fault:
        SDK.address(url)
    assert fault.value.kind == "unreachable"
